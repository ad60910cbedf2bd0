#include "engine/rewrite/unrestricted.hpp"

#include "engine/expr/rebuilt.hpp"

#include <algorithm>

namespace zeroset {

std::optional<Expr> unrestricted(const Expr& expr) {
    const auto restricts = [](const Node& node) { return node.op == Op::Where; };
    if (std::ranges::none_of(expr.nodes(), restricts)) return std::nullopt;
    return rebuilt(expr, [&](ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
        return restricts(node) ? a : builder.apply(node.op, a, b, c, node.number);
    });
}

}  // namespace zeroset
