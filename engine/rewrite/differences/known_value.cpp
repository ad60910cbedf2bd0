#include "engine/rewrite/differences/known_value.hpp"

#include "engine/algebra/node_facts.hpp"

namespace zeroset {
namespace {

constexpr int most_visits = 400;
constexpr Fraction known_zero{.p = 0, .q = 1};
constexpr Fraction known_one{.p = 1, .q = 1};

bool equals(const std::optional<Fraction>& value, const Fraction& other) {
    return value && value->p == other.p && value->q == other.q;
}

/// A function whose operand is 0 or 1.
std::optional<Fraction> known_call(Op op, const std::optional<Fraction>& a) {
    const bool keeps_zero =
        is_any_of(op, {Op::Negate, Op::IntPower, Op::OddRoot, Op::Sqrt, Op::Abs, Op::Sin, Op::Tan,
                       Op::Sinh, Op::Tanh, Op::Asin, Op::Atan, Op::Asinh, Op::Atanh});
    if (equals(a, known_zero) && keeps_zero) return known_zero;
    if (equals(a, known_zero) && is_any_of(op, {Op::Exp, Op::Cos, Op::Cosh, Op::Sinc, Op::Sinhc}))
        return known_one;
    if (equals(a, known_one) && is_any_of(op, {Op::IntPower, Op::OddRoot, Op::Sqrt, Op::Abs}))
        return known_one;
    if (equals(a, known_one) && is_any_of(op, {Op::Log, Op::Log2, Op::Log10})) return known_zero;
    return std::nullopt;
}

std::optional<Fraction> value_within(const ExprBuilder& builder, NodeId id, int& visits) {
    if (--visits < 0) return std::nullopt;
    if (auto exact = exact_fraction(builder, id)) return exact;
    const Node& node = builder.node(id);
    if (arity(node.op) == 1) return known_call(node.op, value_within(builder, node.a, visits));
    if (!is_any_of(node.op, {Op::Add, Op::Subtract, Op::Multiply})) return std::nullopt;
    if (node.op == Op::Subtract && node.a == node.b) return known_zero;
    const auto a = value_within(builder, node.a, visits);
    if (node.op == Op::Multiply && equals(a, known_zero)) return known_zero;
    const auto b = value_within(builder, node.b, visits);
    if (node.op == Op::Multiply) {
        if (equals(b, known_zero)) return known_zero;
        return equals(a, known_one) ? b : equals(b, known_one) ? a : std::nullopt;
    }
    if (node.op == Op::Add && equals(a, known_zero)) return b;
    if (equals(b, known_zero)) return a;
    if (!a || !b || a->q != 1 || b->q != 1) return std::nullopt;
    constexpr long long largest = 1LL << 30U;
    if (a->p > largest || a->p < -largest || b->p > largest || b->p < -largest) return std::nullopt;
    return Fraction{.p = node.op == Op::Add ? a->p + b->p : a->p - b->p, .q = 1};
}

}  // namespace

std::optional<Fraction> known_value(const ExprBuilder& builder, NodeId id) {
    int visits = most_visits;
    return value_within(builder, id, visits);
}

bool is_known_zero(const ExprBuilder& builder, NodeId id) {
    return equals(known_value(builder, id), known_zero);
}

}  // namespace zeroset
