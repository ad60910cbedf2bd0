#include "engine/tape/skeleton.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/algebra/graph_facts.hpp"
#include "engine/expr/copy.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace zeroset {
namespace {

/// Whether a uniform does for the constant: uniform_form says that its value at points is off by no
/// more than one of its units in double.
bool may_be_uniform(const Facts& facts) {
    const Interval<double>& box = *facts.constant;
    const double bound = std::max(box.neg_lo, box.hi);
    const double off = std::max(box.hi - facts.middle, box.neg_lo + facts.middle) * (1.0 + 0x1p-50);
    const bool usual = bound == 0 || (std::abs(bound) > 1e-30 && std::abs(bound) < 1e30);
    return usual && off * 0x1p52 <= bound;
}

}  // namespace

auto SkeletonReader::append_constant(const Facts& facts, bool negated) -> Index {
    const Interval<double> box = negated ? -*facts.constant : *facts.constant;
    if (!may_be_uniform(facts))
        return append({.op = Op::Constant, .lo = -box.neg_lo, .hi = box.hi});
    part_.constants.push_back(box);
    return append(
        {.op = Op::Constant, .number = static_cast<std::int32_t>(part_.constants.size())});
}

std::optional<NodeId> SkeletonReader::waits_for(const Node& node) const {
    const std::array operands{node.a, node.b, node.c};
    const std::span needed = std::span(operands).first(static_cast<std::size_t>(arity(node.op)));
    const auto found = std::ranges::find_if(
        needed, [&](NodeId id) { return !is_constant(id) && place_[id] == unplaced; });
    if (found == needed.end()) return std::nullopt;
    return *found;
}

/// x - c becomes x + (-c), the same to the last bit, so that it has the shape of x + c.
void SkeletonReader::append_operator(NodeId id) {
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

std::optional<Skeleton> SkeletonReader::read(NodeId root, std::size_t most_nodes) {
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

Skeleton skeleton_of(const Expr& expr) {
    const NearestRounding nearest;
    const std::vector<Facts> facts = facts_of(expr);
    auto all = SkeletonReader(expr, facts).read(expr.root(), 4 * expr.nodes().size() + 4);
    return all ? std::move(*all) : Skeleton{};
}

void VaryingPlaces::add(const Skeleton& first, const Skeleton& other) {
    for (std::size_t place = 0; place < varies_.size(); ++place) {
        const Interval<double>& a = first.constants[place];
        const Interval<double>& b = other.constants[place];
        if (a.neg_lo != b.neg_lo || a.hi != b.hi) varies_[place] = true;
    }
}

bool VaryingPlaces::any() const { return std::ranges::find(varies_, true) != varies_.end(); }

ShapeMaker::ShapeMaker(const Skeleton& first, const VaryingPlaces& varying) : first_(first) {
    for (const Node& node : first.nodes) {
        if (node.op == Op::Variable) variable(node.number);
    }
    int next = static_cast<int>(shared_.size());
    for (std::size_t place = 0; place < first.constants.size(); ++place)
        uniform_of_place_.push_back(varying.at(place) ? std::optional(next++) : std::nullopt);
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
    const bool has_place = node.op == Op::Constant && node.number != 0;
    if (!has_place) return copy_node(builder_, node, added);
    const auto place = static_cast<std::size_t>(node.number - 1);
    if (const auto& item = uniform_of_place_[place]) return builder_.variable(variable_w + *item);
    const Interval<double>& box = first_.constants[place];
    return builder_.constant(-box.neg_lo, box.hi);
}

PartShape ShapeMaker::make() {
    std::vector<NodeId> added;
    added.reserve(first_.nodes.size());
    for (const Node& node : first_.nodes)
        added.push_back(add(node, added));
    const auto varying =
        std::ranges::count_if(uniform_of_place_, [](const auto& item) { return item.has_value(); });
    std::vector<std::string> names;
    const std::size_t items = shared_.size() + static_cast<std::size_t>(varying);
    names.reserve(items);
    for (std::size_t item = 1; item < items; ++item)
        names.push_back(std::to_string(item));
    PartShape shape{.expr = builder_.finish(added.back(), std::move(names)),
                    .facts = {},
                    .shared = shared_,
                    .kernel = {}};
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

}  // namespace zeroset
