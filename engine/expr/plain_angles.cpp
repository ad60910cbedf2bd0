#include "engine/expr/plain_angles.hpp"

#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t max_summands = 32;

/// What a sum adds up, in order; nothing for a long one.
std::vector<NodeId> summands(const ExprBuilder& builder, NodeId sum) {
    std::vector<NodeId> open{sum};
    std::vector<NodeId> result;
    while (!open.empty()) {
        const NodeId id = open.back();
        open.pop_back();
        const Node& node = builder.node(id);
        if (node.op == Op::Add) {
            open.push_back(node.b);
            open.push_back(node.a);
        } else {
            result.push_back(id);
        }
        if (result.size() + open.size() > max_summands) return {};
    }
    return result;
}

/// sqrt(T) for the quotient a / sqrt(a^2 + T), for a sum T of even powers.
std::optional<NodeId> other_leg(ExprBuilder& builder, const Node& quotient) {
    const Node root = builder.node(quotient.b);
    if (quotient.op != Op::Divide || root.op != Op::Sqrt) return std::nullopt;
    std::vector<NodeId> squares = summands(builder, root.a);
    const auto own = std::ranges::find(squares, make_int_power(builder, quotient.a, 2));
    if (own == squares.end()) return std::nullopt;
    squares.erase(own);
    const bool never_negative = std::ranges::all_of(squares, [&](NodeId id) {
        return builder.node(id).op == Op::IntPower && builder.node(id).number % 2 == 0;
    });
    if (squares.empty() || !never_negative) return std::nullopt;
    NodeId sum = squares.front();
    for (std::size_t i = 1; i < squares.size(); ++i)
        sum = make_add(builder, sum, squares[i]);
    return make_call(builder, Op::Sqrt, sum);
}

NodeId plain(ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
    const bool wave = node.op == Op::Sin || node.op == Op::Cos;
    if (wave) return make_call(builder, node.op, a);  // without the cut of a new atan2
    if (node.op == Op::Acos || node.op == Op::Asin) {
        const Node quotient = builder.node(a);
        if (const auto leg = other_leg(builder, quotient)) {
            return node.op == Op::Acos ? builder.apply(Op::Atan2, *leg, quotient.a)
                                       : builder.apply(Op::Atan2, quotient.a, *leg);
        }
    }
    return builder.apply(node.op, a, b, c, node.number);
}

}  // namespace

Expr plain_angles(const Expr& expr) {
    const bool any = std::ranges::any_of(
        expr.nodes(), [](const Node& node) { return node.op == Op::Acos || node.op == Op::Asin; });
    if (!any) return expr;
    ExprBuilder builder;
    std::vector<NodeId> now;
    for (const Node& node : expr.nodes()) {
        if (node.op == Op::Constant) {
            now.push_back(builder.constant(node.lo, node.hi));
        } else if (node.op == Op::Variable) {
            now.push_back(builder.variable(node.number));
        } else {
            now.push_back(plain(builder, node, now[node.a], now[node.b], now[node.c]));
        }
    }
    const auto names = expr.parameters();
    return builder.finish(now.back(), {names.begin(), names.end()});
}

}  // namespace zeroset
