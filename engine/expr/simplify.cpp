#include "engine/expr/simplify.hpp"

#include <cmath>
#include <cstdlib>

namespace zeroset {
namespace {

constexpr double largest_exact_integer = 0x1p53;
constexpr double largest_exponent = 0x1p24;  // a float, as derivatives need it

bool is_constant(const ExprBuilder& builder, NodeId id, double value) {
    const Node& node = builder.node(id);
    return node.op == Op::Constant && node.lo == value && node.hi == value;
}

/// Sums, products and powers of integers are exact up to this size.
std::optional<double> exact_integer(double value) {
    if (!(std::abs(value) <= largest_exact_integer)) return std::nullopt;
    return value;
}

/// a / b for integers where it is a multiple of 1/2.
std::optional<double> exact_quotient(double a, double b) {
    const double quotient = a / b;
    if (std::fmod(2 * a, b) != 0) return std::nullopt;
    return exact_integer(quotient);
}

/// n if the node is an exact integer of int range.
std::optional<int> integer_value(const ExprBuilder& builder, NodeId id) {
    const std::optional<double> value = exact_value(builder, id);
    if (!value || std::abs(*value) > largest_exponent || *value != std::floor(*value))
        return std::nullopt;
    return static_cast<int>(*value);
}

NodeId make_int_power(ExprBuilder& builder, NodeId a, int n) {
    if (n < 0) return make_divide(builder, builder.constant(1.0), make_int_power(builder, a, -n));
    if (n == 0) return builder.constant(1.0);
    if (n == 1) return a;
    return builder.apply(Op::IntPower, a, 0, n);
}

/// The node with atan2 replaced by Angle where it is an integer multiple of atan2.
NodeId without_cut(ExprBuilder& builder, NodeId id) {
    const Node node = builder.node(id);
    if (node.op == Op::Atan2) return builder.apply(Op::Angle, node.a, node.b);
    if (node.op == Op::Negate) return make_negate(builder, without_cut(builder, node.a));
    if (node.op != Op::Multiply) return id;
    if (integer_value(builder, node.a)) {
        return make_multiply(builder, node.a, without_cut(builder, node.b));
    }
    if (integer_value(builder, node.b)) {
        return make_multiply(builder, without_cut(builder, node.a), node.b);
    }
    return id;
}

}  // namespace

std::optional<double> exact_value(const ExprBuilder& builder, NodeId id, int depth) {
    const Node& node = builder.node(id);
    if (node.op == Op::Constant) {
        return node.lo == node.hi ? std::optional(node.lo) : std::nullopt;
    }
    const bool leaf = node.op == Op::Variable;
    if (leaf || depth == 0 || op_info(node.op).notation == Notation::Call) return std::nullopt;
    const std::optional<double> a = exact_value(builder, node.a, depth - 1);
    if (!a || *a != std::floor(*a)) return std::nullopt;
    if (node.op == Op::IntPower) return exact_integer(std::pow(*a, node.number));
    if (node.op == Op::Negate) return exact_integer(-*a);
    const std::optional<double> b = exact_value(builder, node.b, depth - 1);
    if (!b || *b != std::floor(*b)) return std::nullopt;
    if (node.op == Op::Add) return exact_integer(*a + *b);
    if (node.op == Op::Subtract) return exact_integer(*a - *b);
    if (node.op == Op::Multiply) return exact_integer(*a * *b);
    if (node.op == Op::Divide && *b != 0) return exact_quotient(*a, *b);
    return std::nullopt;
}

NodeId make_negate(ExprBuilder& builder, NodeId a) {
    const Node node = builder.node(a);
    if (node.op == Op::Constant) return builder.constant(-node.hi, -node.lo);
    if (node.op == Op::Negate) return node.a;
    return builder.apply(Op::Negate, a);
}

NodeId make_add(ExprBuilder& builder, NodeId a, NodeId b) {
    if (is_constant(builder, b, 0.0)) return a;
    return builder.apply(Op::Add, a, b);
}

NodeId make_subtract(ExprBuilder& builder, NodeId a, NodeId b) {
    if (is_constant(builder, b, 0.0)) return a;
    return builder.apply(Op::Subtract, a, b);
}

NodeId make_multiply(ExprBuilder& builder, NodeId a, NodeId b) {
    if (a == b) return make_int_power(builder, a, 2);
    return builder.apply(Op::Multiply, a, b);
}

NodeId make_divide(ExprBuilder& builder, NodeId a, NodeId b) {
    return builder.apply(Op::Divide, a, b);
}

NodeId make_power(ExprBuilder& builder, NodeId a, NodeId b) {
    if (const std::optional<int> n = integer_value(builder, b)) {
        return make_int_power(builder, a, *n);
    }
    if (exact_value(builder, b) == 0.5) return builder.apply(Op::Sqrt, a);
    return builder.apply(Op::Exp, make_multiply(builder, b, builder.apply(Op::Log, a)));
}

NodeId make_call(ExprBuilder& builder, Op function, NodeId a, NodeId b) {
    const bool periodic = function == Op::Sin || function == Op::Cos;
    return builder.apply(function, periodic ? without_cut(builder, a) : a, b);
}

}  // namespace zeroset
