#include "engine/expr/copy.hpp"

namespace zeroset {

NodeId copy_node(ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
    if (node.op == Op::Constant) return builder.constant(node.lo, node.hi);
    if (node.op == Op::Variable) return builder.variable(node.number);
    if (node.op == Op::Field) return builder.look_up(node.field, a, b, c, node.number);
    return builder.apply(node.op, a, b, c, node.number);
}

NodeId copy_node(ExprBuilder& builder, const Node& node, std::span<const NodeId> copies) {
    return copy_node(builder, node, [&](NodeId id) { return copies[id]; });
}

std::vector<NodeId> copy_nodes(ExprBuilder& builder, const Expr& expr) {
    std::vector<NodeId> copies;
    copies.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes())
        copies.push_back(copy_node(builder, node, copies));
    return copies;
}

}  // namespace zeroset
