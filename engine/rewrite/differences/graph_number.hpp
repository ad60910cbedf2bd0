#pragma once

#include "engine/expr/simplify.hpp"
#include "engine/real/format.hpp"
#include "engine/real/sleef.hpp"
#include "engine/special/line_field.hpp"

#include <cmath>

// The carrier that builds a graph: the operations that engine/num/dual.hpp asks of one, so that the
// rules of differentiation that kernels apply to numbers make formulas, too. Private to
// derivatives.cpp.

namespace zeroset {

struct GraphNumber {
    ExprBuilder* builder;
    NodeId id;
};

/// A condition.
struct GraphMask {
    ExprBuilder* builder;
    NodeId id;
};

inline const Format& format_of(const GraphNumber& /*kind*/) { return double_format; }

/// NaN has no node; it stands in values only, which are those of the nodes differentiated.
inline GraphNumber like(const GraphNumber& kind, double value) {
    return std::isnan(value)
               ? kind
               : GraphNumber{.builder = kind.builder, .id = kind.builder->constant(value)};
}

inline GraphNumber operator+(const GraphNumber& a, const GraphNumber& b) {
    return {.builder = a.builder, .id = make_add(*a.builder, a.id, b.id)};
}
inline GraphNumber operator-(const GraphNumber& a, const GraphNumber& b) {
    return {.builder = a.builder, .id = make_subtract(*a.builder, a.id, b.id)};
}
inline GraphNumber operator*(const GraphNumber& a, const GraphNumber& b) {
    return {.builder = a.builder, .id = make_multiply(*a.builder, a.id, b.id)};
}
inline GraphNumber operator/(const GraphNumber& a, const GraphNumber& b) {
    return {.builder = a.builder, .id = make_divide(*a.builder, a.id, b.id)};
}
inline GraphNumber operator-(const GraphNumber& a) {
    return {.builder = a.builder, .id = make_negate(*a.builder, a.id)};
}

inline GraphMask operator<(const GraphNumber& a, const GraphNumber& b) {
    return {.builder = a.builder, .id = a.builder->apply(Op::Less, a.id, b.id)};
}
inline GraphMask operator>(const GraphNumber& a, const GraphNumber& b) { return b < a; }
inline GraphMask operator<=(const GraphNumber& a, const GraphNumber& b) {
    return {.builder = a.builder, .id = a.builder->apply(Op::LessEqual, a.id, b.id)};
}
inline GraphMask operator>=(const GraphNumber& a, const GraphNumber& b) { return b <= a; }
inline GraphMask either(const GraphMask& a, const GraphMask& b) {
    return {.builder = a.builder, .id = make_call(*a.builder, Op::Or, a.id, b.id)};
}
/// Graphs leave out what is no number: whatever is computed with it is none, either.
inline GraphMask unordered(const GraphNumber& a, const GraphNumber& /*b*/) {
    return {.builder = a.builder, .id = a.builder->constant(0.0)};
}

inline GraphNumber select(const GraphMask& condition, const GraphNumber& if_true,
                          const GraphNumber& if_false) {
    ExprBuilder& builder = *condition.builder;
    const bool never = condition.id == builder.constant(0.0);
    if (never || if_true.id == if_false.id) return if_false;
    return {.builder = &builder,
            .id = builder.apply(Op::If, condition.id, if_true.id, if_false.id)};
}
inline GraphNumber select_negative(const GraphNumber& x, const GraphNumber& if_set,
                                   const GraphNumber& if_clear) {
    return select(x < like(x, 0.0), if_set, if_clear);
}

inline GraphNumber square_root(const GraphNumber& a) {
    return {.builder = a.builder, .id = make_call(*a.builder, Op::Sqrt, a.id)};
}
inline GraphNumber magnitude(const GraphNumber& a) {
    return {.builder = a.builder, .id = make_call(*a.builder, Op::Abs, a.id)};
}
inline GraphNumber round_down(const GraphNumber& a) {
    return {.builder = a.builder, .id = make_call(*a.builder, Op::Floor, a.id)};
}
/// A graph keeps an infinite derivative.
inline GraphNumber at_most_steep(const GraphNumber& derivative) { return derivative; }
inline GraphNumber point_power(const GraphNumber& a, int n) {
    return {.builder = a.builder, .id = make_int_power(*a.builder, a.id, n)};
}
inline GraphNumber point_odd_root(const GraphNumber& size, int n) {
    return {.builder = size.builder, .id = make_root(*size.builder, size.id, n)};
}

/// The operator of a function that is taken from a library.
constexpr Op op_of(Elementary function) {
    switch (function) {
        case Elementary::Sin: return Op::Sin;
        case Elementary::Cos: return Op::Cos;
        case Elementary::Tan: return Op::Tan;
        case Elementary::Asin: return Op::Asin;
        case Elementary::Acos: return Op::Acos;
        case Elementary::Atan: return Op::Atan;
        case Elementary::Atan2: return Op::Atan2;
        case Elementary::Exp: return Op::Exp;
        case Elementary::Log: return Op::Log;
        case Elementary::Log10: return Op::Log10;
        case Elementary::Log2: return Op::Log2;
        case Elementary::Cbrt: return Op::OddRoot;
        case Elementary::Sinh: return Op::Sinh;
        case Elementary::Cosh: return Op::Cosh;
        case Elementary::Tanh: return Op::Tanh;
        case Elementary::Asinh: return Op::Asinh;
        case Elementary::Acosh: return Op::Acosh;
        case Elementary::Atanh: return Op::Atanh;
    }
    return Op::Constant;
}

inline GraphNumber elementary(Elementary function, const GraphNumber& a) {
    if (function == Elementary::Cbrt) return point_odd_root(a, 3);
    return {.builder = a.builder, .id = make_call(*a.builder, op_of(function), a.id)};
}
inline GraphNumber elementary(Elementary function, const GraphNumber& a, const GraphNumber& b) {
    return {.builder = a.builder, .id = make_call(*a.builder, op_of(function), a.id, b.id)};
}

/// A field and its derivatives; undefined where their order is higher than that of any known.
inline std::array<GraphNumber, FieldValue::answers> answers(FieldValue /*question*/,
                                                            const Field& field, int derivative,
                                                            const std::array<GraphNumber, 3>& at) {
    ExprBuilder& builder = *at[0].builder;
    const auto* const line = dynamic_cast<const LineField*>(&field);
    if (line != nullptr && line->derivative() && derivative == 0) {
        // These have slopes of their own, which numbered derivatives have not.
        const NodeId zero = builder.constant(0.0);
        const auto node = [&](NodeId id) { return GraphNumber{.builder = &builder, .id = id}; };
        return {node(builder.look_up(field.shared_from_this(), at[0].id, at[1].id, at[2].id)),
                node(builder.look_up(line->derivative(), at[0].id, at[1].id, at[2].id)), node(zero),
                node(zero)};
    }
    const auto number = [&](int of) {
        const NodeId zero = builder.constant(0.0);
        const NodeId id =
            order_of(of) > highest_order
                ? builder.apply(Op::Where, zero, zero)
                : builder.look_up(field.shared_from_this(), at[0].id, at[1].id, at[2].id, of);
        return GraphNumber{.builder = &builder, .id = id};
    };
    return {number(derivative), number(once_more_by(derivative, 0)),
            number(once_more_by(derivative, 1)), number(once_more_by(derivative, 2))};
}

}  // namespace zeroset
