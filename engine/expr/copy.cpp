#include "engine/expr/copy.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

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

std::vector<NodeId> nodes_below(const Expr& expr, NodeId root) {
    std::vector<NodeId> found{root};
    std::unordered_set<NodeId> seen{root};
    for (std::size_t i = 0; i < found.size(); ++i) {
        each_operand(expr.node(found[i]), [&](NodeId operand) {
            if (seen.insert(operand).second) found.push_back(operand);
        });
    }
    std::ranges::sort(found);
    return found;
}

Expr graph_below(const Expr& expr, NodeId root) {
    ExprBuilder builder;
    std::unordered_map<NodeId, NodeId> copies;
    for (const NodeId id : nodes_below(expr, root)) {
        const auto copy_of = [&](NodeId operand) { return copies[operand]; };
        copies[id] = copy_node(builder, expr.node(id), copy_of);
    }
    return builder.finish(copies[root], expr.parameter_names());
}

std::vector<NodeId> copy_nodes(ExprBuilder& builder, const Expr& expr) {
    std::vector<NodeId> copies;
    copies.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes())
        copies.push_back(copy_node(builder, node, copies));
    return copies;
}

}  // namespace zeroset
