#include "engine/expr/simplify.hpp"

#include "engine/expr/constants.hpp"
#include "engine/expr/exact.hpp"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace zeroset {
namespace {

constexpr long long largest_exponent = 1LL << 24U;  // a float, as derivatives need it
constexpr int max_cut_visits = 256;

bool is_constant(const ExprBuilder& builder, NodeId id, double value) {
    const Node& node = builder.node(id);
    return node.op == Op::Constant && node.lo == value && node.hi == value;
}

/// base^exponent with the exponent at least 1; any node is a power of itself.
struct PowerOf {
    NodeId base;
    int exponent;
};

PowerOf as_power(const ExprBuilder& builder, NodeId id) {
    const Node& node = builder.node(id);
    if (node.op == Op::IntPower) return {.base = node.a, .exponent = node.number};
    return {.base = id, .exponent = 1};
}

/// a * b for powers of the same base.
std::optional<NodeId> merged_power(ExprBuilder& builder, NodeId a, NodeId b) {
    const PowerOf left = as_power(builder, a);
    const PowerOf right = as_power(builder, b);
    if (left.base != right.base || left.exponent + right.exponent > largest_exponent)
        return std::nullopt;
    if (builder.node(left.base).op == Op::Constant) return std::nullopt;  // 2*2 stays as typed
    return make_int_power(builder, left.base, left.exponent + right.exponent);
}

bool is_integer(const std::optional<Fraction>& value) { return value && value->q == 1; }

/// The node with atan2 replaced by Angle where integer multiples of atan2 are summands of it;
/// `visits` is how many more operators may be looked at: those that are shared are each time.
NodeId without_cut(ExprBuilder& builder, NodeId id, int& visits) {
    const Node node = builder.node(id);
    if (--visits < 0) return id;
    if (node.op == Op::Atan2) return builder.apply(Op::Angle, node.a, node.b);
    if (node.op == Op::Negate) {
        return make_negate(builder, without_cut(builder, node.a, visits));
    }
    if (node.op == Op::Add || node.op == Op::Subtract) {
        const NodeId left = without_cut(builder, node.a, visits);
        const NodeId right = without_cut(builder, node.b, visits);
        if (left == node.a && right == node.b) return id;
        return node.op == Op::Add ? make_add(builder, left, right)
                                  : make_subtract(builder, left, right);
    }
    if (node.op != Op::Multiply) return id;
    if (is_integer(exact_fraction(builder, node.a))) {
        return make_multiply(builder, node.a, without_cut(builder, node.b, visits));
    }
    if (is_integer(exact_fraction(builder, node.b))) {
        return make_multiply(builder, without_cut(builder, node.a, visits), node.b);
    }
    return id;
}
NodeId without_cut(ExprBuilder& builder, NodeId id) {
    int visits = max_cut_visits;
    return without_cut(builder, id, visits);
}

/// a^(p/q) for p > 0, q > 1 as a power of roots, where that takes few operations.
std::optional<NodeId> power_of_root(ExprBuilder& builder, NodeId a, const Fraction& exponent) {
    const int halvings = std::countr_zero(static_cast<unsigned long long>(exponent.q));
    const long long odd = exponent.q >> halvings;
    if (odd > 15 || halvings > 2 || exponent.p > 30) return std::nullopt;
    NodeId root = odd == 1 ? a : make_root(builder, a, static_cast<int>(odd));
    for (int i = 0; i < halvings; ++i)
        root = make_call(builder, Op::Sqrt, root);
    return make_int_power(builder, root, static_cast<int>(exponent.p));
}

/// Whether the node is a sum of things that are never negative wherever they are defined; not seen
/// in long sums.
bool is_never_negative(const ExprBuilder& builder, NodeId id) {
    constexpr std::size_t longest = 32;
    std::vector<NodeId> summands{id};
    for (std::size_t i = 0; i < summands.size(); ++i) {
        const Node& node = builder.node(summands[i]);
        if (node.op == Op::Add && summands.size() + 2 <= longest) {
            summands.push_back(node.a);
            summands.push_back(node.b);
            continue;
        }
        const bool even = node.op == Op::IntPower && node.number % 2 == 0;
        const bool constant = node.op == Op::Constant && node.lo >= 0;
        const bool root = node.op == Op::Sqrt || node.op == Op::Abs || node.op == Op::Exp;
        if (!even && !constant && !root) return false;
    }
    return true;
}

NodeId make_sqrt(ExprBuilder& builder, NodeId a) {
    const Node node = builder.node(a);
    if (node.op != Op::IntPower || node.number % 2 != 0) return builder.apply(Op::Sqrt, a);
    return make_call(builder, Op::Abs, make_int_power(builder, node.a, node.number / 2));
}

NodeId make_abs(ExprBuilder& builder, NodeId a) {
    const Node node = builder.node(a);
    const bool even = node.op == Op::IntPower && node.number % 2 == 0;
    if (even || node.op == Op::Abs || node.op == Op::Sqrt || node.op == Op::Exp) return a;
    if (node.op == Op::Negate) return make_abs(builder, node.a);
    return builder.apply(Op::Abs, a);
}

NodeId make_not(ExprBuilder& builder, NodeId a) {
    const Node node = builder.node(a);
    if (node.op == Op::Not) return node.a;
    if (node.op == Op::Less) return builder.apply(Op::LessEqual, node.b, node.a);
    if (node.op == Op::LessEqual) return builder.apply(Op::Less, node.b, node.a);
    return builder.apply(Op::Not, a);
}

/// Whether make_negate takes a minus sign away: one of its own, or a number's.
bool has_sign(const Node& node) {
    return node.op == Op::Negate || (node.op == Op::Constant && node.hi < 0.0);
}

NodeId make_cos(ExprBuilder& builder, NodeId a) {
    const NodeId angle = without_cut(builder, a);
    const Node node = builder.node(angle);
    return builder.apply(Op::Cos, node.op == Op::Negate ? node.a : angle);
}

}  // namespace

NodeId make_negate(ExprBuilder& builder, NodeId a) {
    const Node node = builder.node(a);
    if (node.op == Op::Constant) return builder.constant(-node.hi, -node.lo);
    if (node.op == Op::Negate) return node.a;
    if (node.op == Op::Subtract) return make_subtract(builder, node.b, node.a);
    return builder.apply(Op::Negate, a);
}

NodeId make_add(ExprBuilder& builder, NodeId a, NodeId b) {
    const Node right = builder.node(b);
    if (is_constant(builder, b, 0.0)) return a;
    if (is_constant(builder, a, 0.0)) return b;
    if (a == b && builder.node(a).op != Op::Constant)
        return make_multiply(builder, builder.constant(2.0), a);
    if (has_sign(right)) return make_subtract(builder, a, make_negate(builder, b));
    return builder.apply(Op::Add, a, b);
}

NodeId make_subtract(ExprBuilder& builder, NodeId a, NodeId b) {
    const Node right = builder.node(b);
    if (is_constant(builder, b, 0.0)) return a;
    if (is_constant(builder, a, 0.0)) return make_negate(builder, b);
    if (has_sign(right)) return make_add(builder, a, make_negate(builder, b));
    return builder.apply(Op::Subtract, a, b);
}

NodeId make_multiply(ExprBuilder& builder, NodeId a, NodeId b) {
    if (is_constant(builder, a, 1.0)) return b;
    if (is_constant(builder, b, 1.0)) return a;
    if (is_constant(builder, a, -1.0)) return make_negate(builder, b);
    if (const auto power = merged_power(builder, a, b)) return *power;
    const Node left = builder.node(a);
    if (left.op == Op::Multiply) {
        if (const auto power = merged_power(builder, left.b, b)) {
            return make_multiply(builder, left.a, *power);
        }
    }
    return builder.apply(Op::Multiply, a, b);
}

NodeId make_divide(ExprBuilder& builder, NodeId a, NodeId b) {
    if (is_constant(builder, b, 1.0)) return a;
    if (a == b && builder.node(a).op != Op::Constant) {
        // An enclosure of the quotient is wide in boxes beside 0, however small they are.
        const NodeId zero = builder.constant(0.0);
        const NodeId below = builder.apply(Op::Less, a, zero);
        const NodeId above = builder.apply(Op::Less, zero, a);
        return builder.apply(Op::Where, builder.constant(1.0), builder.apply(Op::Or, below, above));
    }
    return builder.apply(Op::Divide, a, b);
}

NodeId make_int_power(ExprBuilder& builder, NodeId a, int n) {
    if (n < 0) return make_divide(builder, builder.constant(1.0), make_int_power(builder, a, -n));
    if (n == 0) return builder.constant(1.0);
    if (n == 1) return a;
    const Node node = builder.node(a);
    if (node.op == Op::IntPower && static_cast<long long>(n) * node.number <= largest_exponent) {
        return make_int_power(builder, node.a, n * node.number);
    }
    if (node.op == Op::Negate) {
        const NodeId power = make_int_power(builder, node.a, n);
        return n % 2 == 0 ? power : make_negate(builder, power);
    }
    if (node.op == Op::Abs && n % 2 == 0) return make_int_power(builder, node.a, n);
    if (node.op == Op::OddRoot && node.number == n) return node.a;
    if (node.op == Op::Sqrt && n % 2 == 0 && is_never_negative(builder, node.a)) {
        return make_int_power(builder, node.a, n / 2);
    }
    return builder.apply(Op::IntPower, a, 0, 0, n);
}

NodeId make_root(ExprBuilder& builder, NodeId a, int n) {
    const Node node = builder.node(a);
    if (node.op == Op::IntPower && node.number == n) return node.a;
    return builder.apply(Op::OddRoot, a, 0, 0, n);
}

NodeId make_power(ExprBuilder& builder, NodeId a, NodeId b) {
    const std::optional<Fraction> exponent = exact_fraction(builder, b);
    if (exponent && std::abs(exponent->p) <= largest_exponent) {
        if (exponent->q == 1) return make_int_power(builder, a, static_cast<int>(exponent->p));
        const bool negative = exponent->p < 0;
        const auto root = power_of_root(builder, a, {.p = std::abs(exponent->p), .q = exponent->q});
        if (root) return negative ? make_divide(builder, builder.constant(1.0), *root) : *root;
    }
    const Node base = builder.node(a);
    if (is_named(base, euler)) return make_call(builder, Op::Exp, b);
    return make_call(builder, Op::Exp, make_multiply(builder, b, make_call(builder, Op::Log, a)));
}

NodeId make_call(ExprBuilder& builder, Op function, NodeId a, NodeId b, NodeId c) {
    if (function == Op::Sqrt) return make_sqrt(builder, a);
    if (function == Op::Abs) return make_abs(builder, a);
    if (function == Op::Cos) return make_cos(builder, a);
    if (function == Op::Sin) return builder.apply(Op::Sin, without_cut(builder, a));
    if (function == Op::Not) return make_not(builder, a);
    if (function == Op::Log && builder.node(a).op == Op::Exp) return builder.node(a).a;
    const bool idempotent =
        function == Op::Min || function == Op::Max || function == Op::And || function == Op::Or;
    if (idempotent && a == b) return a;
    return builder.apply(function, a, b, c);
}

}  // namespace zeroset
