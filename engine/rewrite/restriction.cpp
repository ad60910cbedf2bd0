#include "engine/expr/copy.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/surface_functions.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace zeroset {

namespace {

/// Conditions of one graph as functions that are not above 0 where they hold.
class Bounds {
public:
    explicit Bounds(const Expr& expr) : expr_(expr), copies_(copy_nodes(builder_, expr)) {}

    /// Adds the bounds of a condition; false where it is none of comparisons.
    bool add(NodeId condition) {
        const Node& node = expr_.node(condition);
        if (node.op == Op::And) {
            const std::size_t known = roots_.size();
            if (add(node.a) && add(node.b)) return true;
            roots_.resize(known);
            return false;
        }
        const auto bound = bound_of(condition, false);
        if (bound) roots_.push_back(*bound);
        return bound.has_value();
    }
    [[nodiscard]] Expr part(NodeId node) { return finish(copies_[node]); }
    [[nodiscard]] std::vector<Expr> all() {
        std::vector<Expr> bounds;
        bounds.reserve(roots_.size());
        for (const NodeId root : roots_)
            bounds.push_back(finish(root));
        return bounds;
    }

private:
    [[nodiscard]] Expr finish(NodeId root) {
        const auto names = expr_.parameters();
        return builder_.finish(root, {names.begin(), names.end()});
    }
    /// The bound of a condition, or of its contrary.
    std::optional<NodeId> bound_of(NodeId condition, bool contrary) {
        const Node& node = expr_.node(condition);
        if (node.op == Op::Not) return bound_of(node.a, !contrary);
        if (node.op == Op::Less || node.op == Op::LessEqual) {
            const NodeId a = copies_[contrary ? node.b : node.a];
            const NodeId b = copies_[contrary ? node.a : node.b];
            return make_subtract(builder_, a, b);
        }
        if (node.op != Op::And && node.op != Op::Or) return std::nullopt;
        const auto a = bound_of(node.a, contrary);
        const auto b = bound_of(node.b, contrary);
        if (!a || !b) return std::nullopt;
        const bool both = (node.op == Op::And) != contrary;
        return make_call(builder_, both ? Op::Max : Op::Min, *a, *b);
    }

    const Expr& expr_;
    ExprBuilder builder_;
    std::vector<NodeId> copies_;
    std::vector<NodeId> roots_;
};

}  // namespace

RestrictedExpr without_restriction(const Expr& expr) {
    Bounds bounds(expr);
    NodeId root = expr.root();
    while (expr.node(root).op == Op::Where && bounds.add(expr.node(root).b))
        root = expr.node(root).a;
    return {.function = bounds.part(root), .bounds = bounds.all()};
}

std::optional<Expr> unrestricted(const Expr& expr) {
    const auto restricts = [](const Node& node) { return node.op == Op::Where; };
    if (std::ranges::none_of(expr.nodes(), restricts)) return std::nullopt;
    return rebuilt(expr, [&](ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
        return restricts(node) ? a : copy_node(builder, node, a, b, c);
    });
}

}  // namespace zeroset
