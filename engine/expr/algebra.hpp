#pragma once

#include "engine/expr/facts.hpp"
#include "engine/num/dual.hpp"
#include "engine/num/elementary.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

// What an operator means: one member a row of op.def, over any carrier. The interpreter and the
// JIT both evaluate a graph by `evaluate` below, so they perform the same operations.

namespace zeroset {

/// A computed operand with what is known of its node.
template <class Value>
struct Operand {
    const Value& value;
    const Facts& facts;
};

/// Natural interval extension. Collects where f is defined and where it is proved continuous.
template <class Real>
class IntervalAlgebra {
public:
    using Value = Interval<Real>;
    using Mask = decltype(std::declval<Real>() > std::declval<Real>());
    using In = const Operand<Value>&;

    Value negate(In a) { return -a.value; }
    Value add(In a, In b) { return a.value + b.value; }
    Value subtract(In a, In b) { return a.value - b.value; }
    Value multiply(In a, In b) {
        if (a.facts.constant) return scaled(b, a);
        if (b.facts.constant) return scaled(a, b);
        if (a.facts.nonnegative && b.facts.nonnegative)
            return multiply_nonnegative(a.value, b.value);
        if (a.facts.nonnegative) return multiply_nonnegative_by(a.value, b.value);
        if (b.facts.nonnegative) return multiply_nonnegative_by(b.value, a.value);
        return a.value * b.value;
    }
    Value divide(In a, In b) {
        restrict_to(continuous, no(contains_zero(b.value)));
        return a.value / b.value;
    }
    Value int_power(In a, int n) { return power(a.value, n, a.facts.nonnegative); }
    Value sqrt(In a) {
        if (a.facts.nonnegative) return square_root(a.value);
        return note(zeroset::sqrt(a.value));
    }
    Value abs(In a) { return a.facts.nonnegative ? a.value : absolute(a.value); }
    Value sin(In a) { return zeroset::sin(a.value); }
    Value cos(In a) { return zeroset::cos(a.value); }
    Value acos(In a) { return note(zeroset::acos(a.value)); }
    Value atan2(In y, In x) { return note(zeroset::atan2(y.value, x.value)); }
    Value angle(In y, In x) { return note(zeroset::angle(y.value, x.value)); }
    Value exp(In a) { return zeroset::exp(a.value); }
    Value log(In a) { return note(zeroset::log(a.value)); }
    Value min(In a, In b) { return minimum(a.value, b.value); }
    Value max(In a, In b) { return maximum(a.value, b.value); }

    std::optional<Mask> defined;     ///< absent: everywhere
    std::optional<Mask> continuous;  ///< absent: everywhere

private:
    static Value scaled(In a, In factor) {
        const Interval<double>& c = *factor.facts.constant;
        const bool exact = factor.facts.exact() && representable(c.hi, a.value.hi);
        if (exact && c.hi != 0) return scale(a.value, c.hi);
        // A factor whose enclosure is finite and not 0 in this type makes no NaN.
        const double largest = largest_finite(a.value.hi);
        const double smallest = smallest_normal(a.value.hi);
        if (-c.neg_lo >= smallest && c.hi <= largest) {
            return scale(a.value, factor.value, a.facts.nonnegative);
        }
        if (-c.hi >= smallest && c.neg_lo <= largest) {
            return -scale(a.value, -factor.value, a.facts.nonnegative);
        }
        return a.value * factor.value;
    }
    static void restrict_to(std::optional<Mask>& all, const Mask& where) {
        all = all ? both(*all, where) : where;
    }
    Value note(const PartialRange<Real, Mask>& range) {
        restrict_to(defined, range.defined);
        restrict_to(continuous, range.continuous);
        return range.value;
    }
    Value note(const JumpingRange<Real, Mask>& range) {
        restrict_to(continuous, range.continuous);
        return range.value;
    }
};

/// Value and gradient at a point.
template <class Real>
class DualAlgebra {
public:
    using Value = Dual<Real>;
    using In = const Operand<Value>&;

    Value negate(In a) { return -a.value; }
    Value add(In a, In b) { return a.value + b.value; }
    Value subtract(In a, In b) { return a.value - b.value; }
    Value multiply(In a, In b) { return a.value * b.value; }
    Value divide(In a, In b) { return a.value / b.value; }
    Value int_power(In a, int n) { return power(a.value, n); }
    Value sqrt(In a) { return zeroset::sqrt(a.value); }
    Value abs(In a) { return zeroset::abs(a.value); }
    Value sin(In a) { return zeroset::sin(a.value); }
    Value cos(In a) { return zeroset::cos(a.value); }
    Value acos(In a) { return zeroset::acos(a.value); }
    Value atan2(In y, In x) { return zeroset::atan2(y.value, x.value); }
    Value angle(In y, In x) { return zeroset::atan2(y.value, x.value); }
    Value exp(In a) { return zeroset::exp(a.value); }
    Value log(In a) { return zeroset::log(a.value); }
    Value min(In a, In b) { return zeroset::min(a.value, b.value); }
    Value max(In a, In b) { return zeroset::max(a.value, b.value); }
};

/// One operator on its operands (b is a again for an operator of one operand).
template <class Algebra>
typename Algebra::Value apply(Algebra& algebra, const Node& node,
                              const Operand<typename Algebra::Value>& a,
                              const Operand<typename Algebra::Value>& b) {
    switch (node.op) {
        case Op::Constant:
        case Op::Variable: break;
        case Op::IntPower: return algebra.int_power(a, node.number);
#define ZEROSET_OP_Prefix(id, method, arity) \
    case Op::id: return algebra.method(a);
#define ZEROSET_OP_Infix(id, method, arity) \
    case Op::id: return algebra.method(a, b);
#define ZEROSET_OP_Power(id, method, arity)
#define ZEROSET_OP_Call(id, method, arity) ZEROSET_OP_Call_##arity(id, method)
#define ZEROSET_OP_Internal(id, method, arity) ZEROSET_OP_Call_##arity(id, method)
#define ZEROSET_OP_Call_1(id, method) ZEROSET_OP_Prefix(id, method, 1)
#define ZEROSET_OP_Call_2(id, method) ZEROSET_OP_Infix(id, method, 2)
#define ZEROSET_OP(id, method, spelling, arity, notation) ZEROSET_OP_##notation(id, method, arity)
#include "engine/expr/op.def"
#undef ZEROSET_OP
#undef ZEROSET_OP_Prefix
#undef ZEROSET_OP_Infix
#undef ZEROSET_OP_Power
#undef ZEROSET_OP_Call
#undef ZEROSET_OP_Internal
#undef ZEROSET_OP_Call_1
#undef ZEROSET_OP_Call_2
    }
    return a.value;
}

/// The root's value. `leaf(node, facts)` makes the value of a variable or a constant subexpression.
/// Nodes that are the same for a whole batch are computed first; `varying()` is called between.
template <class Algebra, class Leaf, class Varying>
typename Algebra::Value evaluate(const Expr& expr, std::span<const Facts> facts, Algebra& algebra,
                                 Leaf leaf, Varying varying) {
    std::vector<std::optional<typename Algebra::Value>> values(expr.nodes().size());
    const auto compute = [&](NodeId id) -> typename Algebra::Value {
        const Node& node = expr.node(id);
        if (facts[id].constant || node.op == Op::Variable || node.op == Op::Constant) {
            return leaf(node, facts[id]);
        }
        const NodeId b = op_info(node.op).arity == 2 ? node.b : node.a;
        return apply(algebra, node, {*values[node.a], facts[node.a]}, {*values[b], facts[b]});
    };
    for (NodeId id = 0; id <= expr.root(); ++id) {
        if (facts[id].uniform) values[id] = compute(id);
    }
    varying();
    for (NodeId id = 0; id <= expr.root(); ++id) {
        if (!facts[id].uniform) values[id] = compute(id);
    }
    return *values.back();
}

}  // namespace zeroset
