#pragma once

#include "engine/algebra/operand.hpp"
#include "engine/num/interval.hpp"
#include "jit/llvm/lanes.hpp"

// Interval arithmetic as it is without a promise: (lo, hi), each end rounded to nearest, and
// nothing about domains or continuity. It is what the engine's kernels are measured against and has
// the same shortcuts: tight squares, constant factors, factors known not to be negative. Careful,
// it gives the whole line where the engine does, for 0 times infinity and divisors with zeros;
// bare, it gives anything there.

namespace zeroset::test {

using jit::Lanes;

struct PlainRange {
    Lanes lo;
    Lanes hi;
};

/// The operators that algebraic formulas have.
class PlainAlgebra {
public:
    using Value = PlainRange;
    using In = const Operand<Value>&;

    explicit PlainAlgebra(bool careful) : careful_(careful) {}

    static Value negate(const Value& a) { return {-a.hi, -a.lo}; }
    static Value add(const Value& a, const Value& b) { return {a.lo + b.lo, a.hi + b.hi}; }
    static Value subtract(const Value& a, const Value& b) { return {a.lo - b.hi, a.hi - b.lo}; }

    [[nodiscard]] Value multiply(In a, In b) const {
        if (b.facts.constant) return scale(a.value, b);
        if (a.facts.constant) return scale(b.value, a);
        if (a.facts.nonnegative && b.facts.nonnegative)
            return without_nan({a.value.lo * b.value.lo, a.value.hi * b.value.hi});
        if (a.facts.nonnegative) return multiply_nonnegative_by(a.value, b.value);
        if (b.facts.nonnegative) return multiply_nonnegative_by(b.value, a.value);
        return product(a.value, b.value);
    }

    /// Bare, the divisor's sign is taken to be one.
    [[nodiscard]] Value divide(const Value& a, const Value& b) const {
        const Lanes zero = like(b.lo, 0.0);
        const Value reciprocal{like(b.lo, 1.0) / b.hi, like(b.lo, 1.0) / b.lo};
        const Value quotient = product(a, reciprocal);
        return careful_ ? unless(both(b.lo <= zero, b.hi >= zero), quotient) : quotient;
    }

    static Value int_power(In a, int n) {
        if (n % 2 == 0 && !a.facts.nonnegative) return power(absolute(a.value), n);
        return power(a.value, n);
    }

    static Value sqrt(In a) {
        if (a.facts.nonnegative) return {square_root(a.value.lo), square_root(a.value.hi)};
        const Lanes zero = like(a.value.lo, 0.0);
        return {square_root(maximum(a.value.lo, zero)), square_root(maximum(a.value.hi, zero))};
    }

    static Value abs(In a) { return a.facts.nonnegative ? a.value : absolute(a.value); }
    static Value min(const Value& a, const Value& b) {
        return {minimum(a.lo, b.lo), minimum(a.hi, b.hi)};
    }
    static Value max(const Value& a, const Value& b) {
        return {maximum(a.lo, b.lo), maximum(a.hi, b.hi)};
    }

private:
    static Value scale(const Value& a, In factor) {
        const Lanes c = factor.value.hi;
        if (factor.facts.constant->hi < 0) return {a.hi * c, a.lo * c};
        return {a.lo * c, a.hi * c};
    }
    static Value unless(const jit::LaneMask& unknown, const Value& a) {
        return {select(unknown, like(a.lo, -infinity), a.lo),
                select(unknown, like(a.hi, infinity), a.hi)};
    }
    [[nodiscard]] Value without_nan(const Value& a) const {
        return careful_ ? unless(unordered(a.lo, a.hi), a) : a;
    }
    [[nodiscard]] Value multiply_nonnegative_by(const Value& a, const Value& b) const {
        return without_nan(
            {b.lo * select_negative(b.lo, a.hi, a.lo), b.hi * select_negative(b.hi, a.lo, a.hi)});
    }
    [[nodiscard]] Value product(const Value& a, const Value& b) const {
        const Lanes p = a.lo * b.lo;
        const Lanes q = a.lo * b.hi;
        const Lanes r = a.hi * b.lo;
        const Lanes s = a.hi * b.hi;
        const Value range{minimum(minimum(p, q), minimum(r, s)),
                          maximum(maximum(p, q), maximum(r, s))};
        return careful_ ? unless(either(unordered(p, q), unordered(r, s)), range) : range;
    }
    static Value absolute(const Value& a) {
        return {maximum(maximum(a.lo, -a.hi), like(a.lo, 0.0)), maximum(-a.lo, a.hi)};
    }
    /// The power of an `a` that is not negative, or for odd n.
    static Value power(const Value& a, int n) { return {power(a.lo, n), power(a.hi, n)}; }
    static Lanes power(const Lanes& a, int n) {
        if (n == 1) return a;
        const Lanes half = power(a * a, n / 2);
        return n % 2 == 0 ? half : half * a;
    }

    bool careful_;
};

}  // namespace zeroset::test
