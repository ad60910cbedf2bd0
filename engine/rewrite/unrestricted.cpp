#include "engine/expr/copy.hpp"
#include "engine/rewrite/surface_functions.hpp"

#include <algorithm>

namespace zeroset {

std::optional<Expr> unrestricted(const Expr& expr) {
    const auto restricts = [](const Node& node) { return node.op == Op::Where; };
    if (std::ranges::none_of(expr.nodes(), restricts)) return std::nullopt;
    return rebuilt(expr, [&](ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
        return restricts(node) ? a : copy_node(builder, node, a, b, c);
    });
}

}  // namespace zeroset
