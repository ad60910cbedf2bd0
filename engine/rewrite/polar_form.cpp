#include "engine/expr/copy.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/passes.hpp"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t most_summands = 32;
constexpr int max_depth = 16;           ///< of a product with an angle
constexpr long long max_factor = 1024;  ///< of an angle

/// Summands of a sum, in order; nothing for a long one.
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
        if (result.size() + open.size() > most_summands) return {};
    }
    return result;
}

bool is_even_power(const Node& node) { return node.op == Op::IntPower && node.number % 2 == 0; }

/// a^n for the even power a^2n.
NodeId root_of(ExprBuilder& builder, NodeId power) {
    const Node node = builder.node(power);
    return make_int_power(builder, node.a, node.number / 2);
}

/// sqrt(T) for the quotient a / sqrt(a^2 + T), for a sum T of even powers.
std::optional<NodeId> other_leg(ExprBuilder& builder, const Node& quotient) {
    const Node root = builder.node(quotient.b);
    if (quotient.op != Op::Divide || root.op != Op::Sqrt) return std::nullopt;
    std::vector<NodeId> squares = summands(builder, root.a);
    const auto own = std::ranges::find(squares, make_int_power(builder, quotient.a, 2));
    if (own == squares.end()) return std::nullopt;
    squares.erase(own);
    const bool never_negative =
        std::ranges::all_of(squares, [&](NodeId id) { return is_even_power(builder.node(id)); });
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
    return copy_node(builder, node, a, b, c);
}

/// sqrt(a^2 + b^2 + c^2) as Length(Length(b, a), c) and so on: with the operands in the order of
/// the angles atan2(y, x) and acos(z / r), so that machine code shares what they have in common.
std::optional<NodeId> length_of(ExprBuilder& builder, NodeId sum) {
    const std::vector<NodeId> squares = summands(builder, sum);
    const auto is_even = [&](NodeId id) { return is_even_power(builder.node(id)); };
    if (squares.size() < 2 || !std::ranges::all_of(squares, is_even)) return std::nullopt;
    NodeId length =
        builder.apply(Op::Length, root_of(builder, squares[1]), root_of(builder, squares[0]));
    for (std::size_t i = 2; i < squares.size(); ++i)
        length = builder.apply(Op::Length, length, root_of(builder, squares[i]));
    return length;
}

/// An angle times a whole number.
struct Multiple {
    NodeId angle;
    long long factor;
};

std::optional<Multiple> multiple_of_angle(const ExprBuilder& builder, NodeId id, int depth = 0) {
    const Node& node = builder.node(id);
    if (node.op == Op::Angle || node.op == Op::Atan2) return Multiple{.angle = id, .factor = 1};
    if (depth > max_depth) return std::nullopt;
    const auto times = [&](NodeId operand, long long factor) {
        auto inner = multiple_of_angle(builder, operand, depth + 1);
        if (inner) inner->factor *= factor;
        return inner && std::abs(inner->factor) <= max_factor ? inner : std::nullopt;
    };
    if (node.op == Op::Negate) return times(node.a, -1);
    if (node.op != Op::Multiply) return std::nullopt;
    const auto whole = [&](NodeId operand) {
        const auto value = exact_fraction(builder, operand);
        return value && value->q == 1 && std::abs(value->p) <= max_factor ? value->p : 0;
    };
    if (const long long factor = whole(node.a)) return times(node.b, factor);
    if (const long long factor = whole(node.b)) return times(node.a, factor);
    return std::nullopt;
}

/// A sine or cosine, as a wave of a multiple of an angle if it is one.
NodeId wave_of(ExprBuilder& builder, Op op, NodeId a) {
    const auto multiple = multiple_of_angle(builder, a);
    if (!multiple) return builder.apply(op, a);
    const Node angle = builder.node(multiple->angle);
    const Op wave = op == Op::Sin ? Op::AngleSin : Op::AngleCos;
    const int factor = static_cast<int>(std::abs(multiple->factor));
    const NodeId result = builder.apply(wave, angle.a, angle.b, 0, factor);
    return op == Op::Sin && multiple->factor < 0 ? builder.apply(Op::Negate, result) : result;
}

/// The legs that a chain of lengths measures.
std::vector<NodeId> legs(const ExprBuilder& builder, NodeId length) {
    std::vector<NodeId> result;
    NodeId id = length;
    for (; builder.node(id).op == Op::Length; id = builder.node(id).a)
        result.push_back(builder.node(id).b);
    result.push_back(id);
    return result;
}

/// k a / sqrt(a^2 + ...) as k times the cosine of an angle, which has a bound.
std::optional<NodeId> share_of_length(ExprBuilder& builder, NodeId product, NodeId length) {
    if (builder.node(length).op != Op::Length) return std::nullopt;
    std::vector<NodeId> others = legs(builder, length);
    const Node factors = builder.node(product);
    const auto is_leg = [&](NodeId id) { return std::ranges::find(others, id) != others.end(); };
    if (!is_leg(product)) {
        if (factors.op == Op::Negate) {
            const auto share = share_of_length(builder, factors.a, length);
            return share ? std::optional(make_negate(builder, *share)) : share;
        }
        if (factors.op != Op::Multiply) return std::nullopt;
        for (const auto& [part, rest] : {std::pair(factors.a, factors.b), {factors.b, factors.a}}) {
            if (const auto share = share_of_length(builder, part, length)) {
                return make_multiply(builder, rest, *share);
            }
        }
        return std::nullopt;
    }
    others.erase(std::ranges::find(others, product));
    NodeId across = others.back();
    for (std::size_t i = others.size() - 1; i-- > 0;)
        across = builder.apply(Op::Length, across, others[i]);
    return builder.apply(Op::AngleCos, across, product, 0, 1);
}

NodeId polar(ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
    if (node.op == Op::Divide) {
        if (const auto share = share_of_length(builder, a, b)) return *share;
    }
    if (node.op == Op::Sin || node.op == Op::Cos) return wave_of(builder, node.op, a);
    if (node.op == Op::Sqrt) {
        if (const auto length = length_of(builder, a)) return *length;
    }
    return copy_node(builder, node, a, b, c);
}

bool has_any(const Expr& expr, std::initializer_list<Op> ops) {
    return std::ranges::any_of(expr.nodes(), [&](const Node& node) {
        return std::ranges::find(ops, node.op) != ops.end();
    });
}

}  // namespace

Expr plain_angles(const Expr& expr) {
    return has_any(expr, {Op::Acos, Op::Asin}) ? rebuilt(expr, plain) : expr;
}

Expr polar_form(const Expr& expr) {
    return has_any(expr, {Op::Angle, Op::Atan2, Op::Sqrt}) ? rebuilt(expr, polar) : expr;
}

}  // namespace zeroset
