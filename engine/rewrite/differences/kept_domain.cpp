#include "engine/rewrite/differences/kept_domain.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// `operands(op)`: how many of a node's operands are gone to.
std::set<NodeId> collected(const ExprBuilder& builder, std::vector<NodeId> open, auto operands) {
    std::set<NodeId> nodes;
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        if (!nodes.insert(id).second) continue;
        const Node& node = builder.node(id);
        const int count = operands(node.op);
        if (count > 0) open.push_back(node.a);
        if (count > 1) open.push_back(node.b);
        if (count > 2) open.push_back(node.c);
    }
    return nodes;
}

/// The nodes that are computed wherever the functions are.
std::set<NodeId> computed(const ExprBuilder& builder, std::vector<NodeId> functions) {
    return collected(builder, std::move(functions),
                     [](Op op) { return op == Op::If ? 1 : arity(op); });
}

/// Whether the node has no value somewhere where what it is computed from has.
bool may_lack_value(const ExprBuilder& builder, NodeFacts& facts, NodeId id) {
    const Node& node = builder.node(id);
    if (node.op != Op::If) return facts.is_partial(id);
    return std::ranges::any_of(collected(builder, {node.b, node.c}, &arity),
                               [&](NodeId part) { return facts.is_partial(part); });
}

/// 0 where the node has a value.
NodeId nothing_of(ExprBuilder& builder, NodeId id) {
    const Node node = builder.node(id);
    const NodeId zero = builder.constant(0.0);
    if (node.op == Op::Where) return builder.apply(Op::Where, zero, node.b);
    const NodeId value = node.op == Op::Atan2 ? builder.apply(Op::Angle, node.a, node.b) : id;
    return builder.apply(Op::Multiply, zero, value);
}

}  // namespace

NodeId with_domain_of(ExprBuilder& builder, NodeFacts& facts, NodeId function,
                      std::span<const NodeId> terms, std::initializer_list<Op> divided) {
    const std::set<NodeId> kept = computed(builder, {function});
    for (const NodeId id : computed(builder, {terms.begin(), terms.end()})) {
        if (kept.contains(id) || !may_lack_value(builder, facts, id)) continue;
        if (std::ranges::find(divided, builder.node(id).op) != divided.end()) continue;
        function = builder.apply(Op::Add, function, nothing_of(builder, id));
    }
    return function;
}

}  // namespace zeroset
