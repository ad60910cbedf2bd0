#include "engine/tape/parts.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/algebra/switches.hpp"
#include "engine/real/rounding.hpp"
#include "engine/tape/skeleton.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <unordered_map>

namespace zeroset {
namespace {

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
        const Op op = expr.node(id).op;
        plain[id] = !may_be_operand(op) && !is_switch(op);
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

/// Parts of the same shape together, in the order of the first ones.
std::vector<std::vector<Skeleton>> grouped(const Expr& expr, std::span<const Facts> facts,
                                           std::size_t most_nodes) {
    SkeletonReader reader(expr, facts);
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
        VaryingPlaces varying(group.front());
        for (const Skeleton& part : group)
            varying.add(group.front(), part);
        ShapeMaker maker(group.front(), varying);
        parts.shapes.push_back(maker.make());
        for (const Skeleton& part : group) {
            parts.of_node[part.root] = static_cast<std::uint32_t>(parts.parts.size());
            parts.parts.push_back({.root = part.root,
                                   .shape = parts.shapes.size() - 1,
                                   .uniforms = maker.uniforms_of(part)});
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
