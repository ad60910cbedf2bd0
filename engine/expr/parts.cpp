#include "engine/expr/parts.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/expr/switches.hpp"
#include "engine/num/rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <unordered_map>

namespace zeroset {
namespace {

using Index = std::uint32_t;

/// A part as nodes in the order in which it is read, with places for constants: a Constant whose
/// `number` is above 0 is place number - 1. The others are the same in all parts of a shape.
struct Skeleton {
    NodeId root = 0;
    std::vector<Node> nodes;
    std::vector<Interval<double>> constants;  ///< of the places

    /// Equal for parts of one shape.
    [[nodiscard]] std::string key() const { return key_of(nodes); }
};

/// Whether a uniform does for the constant: uniform_form says that its value at points is off by no
/// more than one of its units in double.
bool may_be_uniform(const Facts& facts) {
    const Interval<double>& box = *facts.constant;
    const double bound = std::max(box.neg_lo, box.hi);
    const double off = std::max(box.hi - facts.middle, box.neg_lo + facts.middle) * (1.0 + 0x1p-50);
    const bool usual = bound == 0 || (std::abs(bound) > 1e-30 && std::abs(bound) < 1e30);
    return usual && off * 0x1p52 <= bound;
}

/// Reads parts one by one.
class PartReader {
public:
    PartReader(const Expr& expr, std::span<const Facts> facts)
        : expr_(expr), facts_(facts), place_(expr.nodes().size(), unplaced) {}

    /// Nothing where the part has more nodes than `most_nodes`.
    std::optional<Skeleton> read(NodeId root, std::size_t most_nodes);

private:
    static constexpr Index unplaced = ~Index{0};

    bool is_constant(NodeId id) const { return facts_[id].constant.has_value(); }
    Index append(const Node& node) {
        part_.nodes.push_back(node);
        return static_cast<Index>(part_.nodes.size() - 1);
    }
    /// A place for a constant wherever it is used.
    Index append_constant(const Facts& facts, bool negated);
    void append_operator(NodeId id);
    /// The first operand that has to be read before the node.
    [[nodiscard]] std::optional<NodeId> waits_for(const Node& node) const;

    const Expr& expr_;
    std::span<const Facts> facts_;
    std::vector<Index> place_;  ///< in the part at work
    std::vector<NodeId> read_;  ///< those that have one
    Skeleton part_;
};

Index PartReader::append_constant(const Facts& facts, bool negated) {
    const Interval<double> box = negated ? -*facts.constant : *facts.constant;
    if (!may_be_uniform(facts))
        return append({.op = Op::Constant, .lo = -box.neg_lo, .hi = box.hi});
    part_.constants.push_back(box);
    return append(
        {.op = Op::Constant, .number = static_cast<std::int32_t>(part_.constants.size())});
}

std::optional<NodeId> PartReader::waits_for(const Node& node) const {
    const std::array operands{node.a, node.b, node.c};
    const std::span needed = std::span(operands).first(static_cast<std::size_t>(arity(node.op)));
    const auto found = std::ranges::find_if(
        needed, [&](NodeId id) { return !is_constant(id) && place_[id] == unplaced; });
    if (found == needed.end()) return std::nullopt;
    return *found;
}

/// x - c becomes x + (-c), the same to the last bit, so that it has the shape of x + c.
void PartReader::append_operator(NodeId id) {
    Node node = expr_.node(id);
    const auto operands = static_cast<std::size_t>(arity(node.op));
    const bool less_constant = node.op == Op::Subtract && is_constant(node.b);
    if (less_constant) node.op = Op::Add;
    const std::array of_node{&node.a, &node.b, &node.c};
    for (std::size_t k = 0; k < of_node.size(); ++k) {
        NodeId& operand = *of_node[k];
        if (k >= operands) {
            operand = 0;
        } else if (is_constant(operand)) {
            operand = append_constant(facts_[operand], less_constant);
        } else {
            operand = place_[operand];
        }
    }
    place_[id] = append(node);
    read_.push_back(id);
}

std::optional<Skeleton> PartReader::read(NodeId root, std::size_t most_nodes) {
    part_ = {.root = root, .nodes = {}, .constants = {}};
    std::vector<NodeId> stack{root};
    while (!stack.empty() && part_.nodes.size() <= most_nodes) {
        const NodeId id = stack.back();
        if (place_[id] != unplaced) {
            stack.pop_back();
        } else if (const auto operand = waits_for(expr_.node(id))) {
            stack.push_back(*operand);
        } else {
            stack.pop_back();
            append_operator(id);
        }
    }
    for (const NodeId id : read_)
        place_[id] = unplaced;
    read_.clear();
    if (part_.nodes.size() > most_nodes) return std::nullopt;
    return std::move(part_);
}

/// The uppermost nodes that depend on no choice and no switch, but for those that need no code.
/// Oriented forms say more than a part's code hands on, and stay with the choices.
std::vector<NodeId> roots_of(const Expr& expr, std::span<const Facts> facts) {
    const std::size_t count = expr.nodes().size();
    std::vector<bool> plain(count, true);
    std::vector<bool> needed(count, false);
    const auto for_operands = [&](NodeId id, auto action) {
        const Node& node = expr.node(id);
        const std::array operands{node.a, node.b, node.c};
        const int number = is_leaf(node, facts[id]) ? 0 : arity(node.op);
        std::for_each_n(operands.begin(), number, action);
    };
    for (NodeId id = 0; id < count; ++id) {
        if (facts[id].uniform) continue;
        plain[id] = !is_choice(expr.node(id).op) && !is_switch(expr.node(id).op);
        for_operands(id, [&](NodeId operand) { plain[id] = plain[id] && plain[operand]; });
    }
    std::vector<NodeId> roots;
    if (plain[expr.root()]) return roots;
    needed[expr.root()] = true;
    for (NodeId id = expr.root() + 1; id-- > 0;) {
        if (!needed[id] || facts[id].uniform || is_leaf(expr.node(id), facts[id])) continue;
        if (plain[id] && expr.node(id).op != Op::Oriented) {
            roots.push_back(id);
        } else {
            for_operands(id, [&](NodeId operand) { needed[operand] = true; });
        }
    }
    return roots;
}

/// Makes the code's graph of parts with the same key: places that hold the same constant in all of
/// them hold it in the graph, too; the others become uniforms.
class ShapeMaker {
public:
    explicit ShapeMaker(std::span<const Skeleton> parts) : parts_(parts) {}

    PartShape make();
    /// The part's values for the shape that was made.
    [[nodiscard]] Uniforms uniforms_of(const Skeleton& part) const;

private:
    void find_varying();
    NodeId add(const Node& node, std::span<const NodeId> added);
    /// The number of the shape's variable that is the formula's.
    int variable(int number);

    std::span<const Skeleton> parts_;
    std::vector<std::optional<int>> uniform_of_place_;  ///< nothing where all have the same
    std::vector<std::size_t> shared_;
    ExprBuilder builder_;
};

void ShapeMaker::find_varying() {
    const Skeleton& first = parts_.front();
    for (const Node& node : first.nodes) {
        if (node.op == Op::Variable) variable(node.number);
    }
    int next = static_cast<int>(shared_.size());
    for (std::size_t place = 0; place < first.constants.size(); ++place) {
        const Interval<double>& box = first.constants[place];
        const bool same = std::ranges::all_of(parts_, [&](const Skeleton& part) {
            return part.constants[place].neg_lo == box.neg_lo && part.constants[place].hi == box.hi;
        });
        uniform_of_place_.push_back(same ? std::nullopt : std::optional(next++));
    }
}

int ShapeMaker::variable(int number) {
    if (number < variable_w) return number;
    const auto item = static_cast<std::size_t>(number - variable_w);
    const auto found = std::ranges::find(shared_, item);
    const auto place = found - shared_.begin();
    if (found == shared_.end()) shared_.push_back(item);
    return variable_w + static_cast<int>(place);
}

NodeId ShapeMaker::add(const Node& node, std::span<const NodeId> added) {
    if (node.op == Op::Variable) return builder_.variable(variable(node.number));
    if (node.op != Op::Constant) {
        return builder_.apply(node.op, added[node.a], added[node.b], added[node.c], node.number);
    }
    if (node.number == 0) return builder_.constant(node.lo, node.hi);
    const auto place = static_cast<std::size_t>(node.number - 1);
    if (const auto& item = uniform_of_place_[place]) return builder_.variable(variable_w + *item);
    const Interval<double>& box = parts_.front().constants[place];
    return builder_.constant(-box.neg_lo, box.hi);
}

PartShape ShapeMaker::make() {
    find_varying();
    std::vector<NodeId> added;
    for (const Node& node : parts_.front().nodes) {
        added.push_back(0);
        added.back() = add(node, added);
    }
    const auto varying =
        std::ranges::count_if(uniform_of_place_, [](const auto& item) { return item.has_value(); });
    std::vector<std::string> names;
    const std::size_t items = shared_.size() + static_cast<std::size_t>(varying);
    for (std::size_t item = 1; item < items; ++item)
        names.push_back(std::to_string(item));
    PartShape shape{builder_.finish(added.back(), std::move(names)), {}, shared_, {}};
    shape.facts = facts_of(shape.expr).back();
    return shape;
}

Uniforms ShapeMaker::uniforms_of(const Skeleton& part) const {
    Uniforms uniforms;
    for (std::size_t item = 0; item < shared_.size(); ++item)
        uniforms.set(item, 0);
    for (std::size_t place = 0; place < part.constants.size(); ++place) {
        const Interval<double>& box = part.constants[place];
        if (const auto& item = uniform_of_place_[place])
            uniforms.set(static_cast<std::size_t>(*item), -box.neg_lo, box.hi);
    }
    return uniforms;
}

/// Parts of the same shape together, in the order of the first ones.
std::vector<std::vector<Skeleton>> grouped(const Expr& expr, std::span<const Facts> facts,
                                           std::size_t most_nodes) {
    PartReader reader(expr, facts);
    std::unordered_map<std::string, std::size_t> known;
    std::vector<std::vector<Skeleton>> groups;
    // Parts may overlap: what they have in common would be computed again and again.
    std::size_t left = 4 * expr.nodes().size();
    for (const NodeId root : roots_of(expr, facts)) {
        auto part = reader.read(root, std::min(most_nodes, left));
        if (!part) continue;
        left -= part->nodes.size();
        const auto [entry, is_new] = known.try_emplace(part->key(), groups.size());
        if (is_new) groups.emplace_back();
        groups[entry->second].push_back(std::move(*part));
    }
    return groups;
}

/// The uniforms of the formula that a shape uses, then those of the part.
template <class Real>
const Real* joined(const PartShape& shape, std::span<const Real> own, const Real* of_formula,
                   std::size_t numbers_an_item) {
    if (shape.shared.empty()) return own.data();
    thread_local std::vector<Real> all;
    all.assign(own.begin(), own.end());
    for (std::size_t i = 0; i < shape.shared.size(); ++i) {
        std::copy_n(of_formula + numbers_an_item * shape.shared[i], numbers_an_item,
                    all.data() + numbers_an_item * i);
    }
    return all.data();
}

}  // namespace

bool is_choice(Op op) { return op == Op::Min || op == Op::Max || op == Op::If || op == Op::Where; }

bool is_alternative(Op choice, std::size_t k) {
    if (choice == Op::Where) return k == 0;
    return choice != Op::If || k > 0;
}

std::size_t Parts::nodes() const {
    return std::transform_reduce(shapes.begin(), shapes.end(), std::size_t{0}, std::plus{},
                                 [](const PartShape& shape) { return shape.expr.nodes().size(); });
}

void Parts::make_code(const MakeCode& make) {
    for (PartShape& shape : shapes) {
        if (auto kernel = make(shape.expr)) shape.kernel = std::move(*kernel);
    }
    for (std::uint32_t& part : of_node) {
        if (part != none && !shapes[parts[part].shape].kernel) part = none;
    }
}

Parts parts_of(const Expr& expr, std::span<const Facts> facts, std::size_t most_nodes) {
    const NearestRounding nearest;
    auto groups = grouped(expr, facts, most_nodes);
    std::ranges::stable_sort(groups, std::greater{}, [](const std::vector<Skeleton>& group) {
        return group.size() * group.front().nodes.size();
    });
    Parts parts;
    parts.of_node.assign(expr.nodes().size(), Parts::none);
    std::size_t nodes = 0;
    for (const std::vector<Skeleton>& group : groups) {
        nodes += group.front().nodes.size();
        if (nodes > most_nodes) break;
        ShapeMaker maker(group);
        parts.shapes.push_back(maker.make());
        for (const Skeleton& part : group) {
            parts.of_node[part.root] = static_cast<std::uint32_t>(parts.parts.size());
            parts.parts.push_back({part.root, parts.shapes.size() - 1, maker.uniforms_of(part)});
        }
    }
    return parts;
}

template <class Real>
const Real* box_uniforms(const PartShape& shape, const Part& part, const Real* of_formula) {
    return joined<Real>(shape, part.uniforms.all_boxes<Real>(), of_formula, 2);
}

template <class Real>
const Real* point_uniforms(const PartShape& shape, const Part& part, const Real* of_formula) {
    return joined<Real>(shape, part.uniforms.all_points<Real>(), of_formula, 1);
}

template const float* box_uniforms(const PartShape&, const Part&, const float*);
template const double* box_uniforms(const PartShape&, const Part&, const double*);
template const float* point_uniforms(const PartShape&, const Part&, const float*);
template const double* point_uniforms(const PartShape&, const Part&, const double*);

}  // namespace zeroset
