#pragma once

#include "engine/expr/expr.hpp"

#include <vector>

namespace zeroset {

/// Makes each operator of a graph again by `make(builder, node, a, b, c)` from its new operands;
/// returns what its nodes became.
std::vector<NodeId> rebuild(ExprBuilder& builder, const Expr& expr, auto make) {
    std::vector<NodeId> now;
    now.reserve(expr.nodes().size());
    for (const Node& node : expr.nodes()) {
        if (node.op == Op::Constant) {
            now.push_back(builder.constant(node.lo, node.hi));
        } else if (node.op == Op::Variable) {
            now.push_back(builder.variable(node.number));
        } else {
            now.push_back(make(builder, node, now[node.a], now[node.b], now[node.c]));
        }
    }
    return now;
}

/// The graph that it comes to.
Expr rebuilt(ExprBuilder& builder, const Expr& expr, auto make) {
    const NodeId root = rebuild(builder, expr, make).back();
    const auto names = expr.parameters();
    return builder.finish(root, {names.begin(), names.end()});
}

Expr rebuilt(const Expr& expr, auto make) {
    ExprBuilder builder;
    return rebuilt(builder, expr, make);
}

}  // namespace zeroset
