#pragma once

#include "engine/expr/expr.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

// Copies of graphs, node by node: as they are, or with other nodes in place of some.

namespace zeroset {

/// The node over these operands, of which it takes as many as it has; a leaf as it is.
NodeId copy_node(ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c);

/// The node over `copy_of(operand)` for each operand that it has.
template <std::invocable<NodeId> CopyOf>
NodeId copy_node(ExprBuilder& builder, const Node& node, CopyOf copy_of) {
    const int operands = arity(node.op);
    return copy_node(builder, node, operands > 0 ? copy_of(node.a) : 0,
                     operands > 1 ? copy_of(node.b) : 0, operands > 2 ? copy_of(node.c) : 0);
}

/// The node over the copies of its operands: copies[id] stands for node `id` of its graph.
NodeId copy_node(ExprBuilder& builder, const Node& node, std::span<const NodeId> copies);

/// Copies a graph: leaves as they are, operators by `make(builder, node, a, b, c)` from their new
/// operands. Returns the copy of each node.
std::vector<NodeId> copy_nodes(ExprBuilder& builder, const Expr& expr, auto make) {
    std::vector<NodeId> copies;
    copies.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes()) {
        const bool leaf = arity(node.op) == 0;
        copies.push_back(leaf
                             ? copy_node(builder, node, copies)
                             : make(builder, node, copies[node.a], copies[node.b], copies[node.c]));
    }
    return copies;
}

/// Copies a graph as it is. Returns the copy of each node.
std::vector<NodeId> copy_nodes(ExprBuilder& builder, const Expr& expr);

/// Calls visit(operand) for each operand that a node has.
void each_operand(const Node& node, auto visit) {
    const std::array operands{node.a, node.b, node.c};
    for (int k = 0; k < arity(node.op); ++k)
        visit(operands[static_cast<std::size_t>(k)]);
}

/// A node and all that it is made of, operands first.
std::vector<NodeId> nodes_below(const Expr& expr, NodeId root);

/// The graph below a node, with the names of all parameters.
Expr graph_below(const Expr& expr, NodeId root);

/// A graph rebuilt with the nodes of a builder, its operators as in `copy_nodes`.
Expr rebuilt(ExprBuilder& builder, const Expr& expr, auto make) {
    const NodeId root = copy_nodes(builder, expr, make).back();
    const auto names = expr.parameters();
    return builder.finish(root, {names.begin(), names.end()});
}

/// A graph rebuilt by itself, its operators as in `copy_nodes`.
Expr rebuilt(const Expr& expr, auto make) {
    ExprBuilder builder;
    return rebuilt(builder, expr, make);
}

}  // namespace zeroset
