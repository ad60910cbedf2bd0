#pragma once

#include "engine/num/cardinal.hpp"
#include "engine/num/polar.hpp"
#include "engine/num/steps.hpp"
#include "engine/real/sleef.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

// Value and gradient by forward differentiation, over any carrier. Not rounded outward. At a kink
// the gradient is that of one side. An infinite derivative is replaced by a very large one, so that
// a constant operand still has the slope 0.

namespace zeroset {

/// df/dx, df/dy, df/dz; an absent one is 0 at every point. Stored compactly, as the interpreter
/// keeps many of them in blocks of numbers.
template <class Real>
class Slopes {
public:
    Slopes() = default;
    Slopes(const Real& x, const Real& y, const Real& z) : slopes_{x, y, z}, known_(7) {}

    [[nodiscard]] bool has(std::size_t i) const { return (known_ >> i & 1U) != 0; }
    /// The i-th slope, which must not be absent.
    [[nodiscard]] const Real& known(std::size_t i) const { return slopes_[i]; }
    [[nodiscard]] std::optional<Real> operator[](std::size_t i) const {
        return has(i) ? std::optional<Real>(slopes_[i]) : std::nullopt;
    }
    void set(std::size_t i, const Real& slope) {
        slopes_[i] = slope;
        known_ |= 1U << i;
    }

private:
    std::array<Real, 3> slopes_;
    unsigned known_ = 0;
};

template <class Real>
struct Dual {
    Real value;
    Slopes<Real> slope;
};

/// A derivative >= 0, possibly infinite, cut to at most 2^60.
template <class Real>
Real at_most_steep(const Real& derivative) {
    return minimum(derivative, like(derivative, 0x1p60));
}

/// g(a) from its value and the derivative g'(a).
template <class Real>
Dual<Real> chain(const Real& value, const Real& derivative, const Dual<Real>& a) {
    Dual<Real> result{value, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.slope.has(i)) result.slope.set(i, derivative * a.slope.known(i));
    }
    return result;
}

/// g(a, b) from its value and its partial derivatives.
template <class Real>
Dual<Real> chain(const Real& value, const Real& by_a, const Dual<Real>& a, const Real& by_b,
                 const Dual<Real>& b) {
    Dual<Real> result{value, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        const bool in_a = a.slope.has(i);
        const bool in_b = b.slope.has(i);
        if (in_a && in_b) {
            result.slope.set(i, by_a * a.slope.known(i) + by_b * b.slope.known(i));
        } else if (in_a) {
            result.slope.set(i, by_a * a.slope.known(i));
        } else if (in_b) {
            result.slope.set(i, by_b * b.slope.known(i));
        }
    }
    return result;
}

/// g(operands...) from its value and its partial derivatives.
template <class Real>
Dual<Real> chain(const Real& value, const std::array<Real, 3>& by,
                 const std::array<const Dual<Real>*, 3>& operands) {
    Dual<Real> result{value, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        std::optional<Real> sum;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!operands[k]->slope.has(i)) continue;
            const Real term = by[k] * operands[k]->slope.known(i);
            sum = sum ? *sum + term : term;
        }
        if (sum) result.slope.set(i, *sum);
    }
    return result;
}

template <class Real>
Dual<Real> operator-(const Dual<Real>& a) {
    Dual<Real> result{-a.value, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.slope.has(i)) result.slope.set(i, -a.slope.known(i));
    }
    return result;
}

template <class Real>
Dual<Real> operator+(const Dual<Real>& a, const Dual<Real>& b) {
    Dual<Real> result{a.value + b.value, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        const bool in_a = a.slope.has(i);
        const bool in_b = b.slope.has(i);
        if (in_a && in_b) {
            result.slope.set(i, a.slope.known(i) + b.slope.known(i));
        } else if (in_a || in_b) {
            result.slope.set(i, in_a ? a.slope.known(i) : b.slope.known(i));
        }
    }
    return result;
}

template <class Real>
Dual<Real> operator-(const Dual<Real>& a, const Dual<Real>& b) {
    Dual<Real> result = a + (-b);
    result.value = a.value - b.value;
    return result;
}

template <class Real>
Dual<Real> operator*(const Dual<Real>& a, const Dual<Real>& b) {
    return chain(a.value * b.value, b.value, a, a.value, b);
}

template <class Real>
Dual<Real> operator/(const Dual<Real>& a, const Dual<Real>& b) {
    const Real reciprocal = like(b.value, 1.0) / b.value;
    const Real quotient = a.value / b.value;
    return chain(quotient, reciprocal, a, -(quotient * reciprocal), b);
}

template <class Real>
Real point_power(const Real& a, int n) {
    if (n == 1) return a;
    const Real half = point_power(a * a, n / 2);
    return n % 2 == 0 ? half : half * a;
}

/// a^n for n >= 2.
template <class Real>
Dual<Real> power(const Dual<Real>& a, int n) {
    const Real below = point_power(a.value, n - 1);
    return chain(below * a.value, below * like(a.value, n), a);
}

template <class Real>
Dual<Real> sqrt(const Dual<Real>& a) {
    const Real root = square_root(a.value);
    return chain(root, at_most_steep(like(root, 0.5) / root), a);
}

template <class Real>
Dual<Real> abs(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    return chain(magnitude(a.value), select_negative(a.value, -one, one), a);
}

template <class Real>
Dual<Real> sin(const Dual<Real>& a) {
    return chain(elementary(Elementary::Sin, a.value), elementary(Elementary::Cos, a.value), a);
}

template <class Real>
Dual<Real> cos(const Dual<Real>& a) {
    return chain(elementary(Elementary::Cos, a.value), -elementary(Elementary::Sin, a.value), a);
}

template <class Real>
Dual<Real> acos(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    const Real steepness = at_most_steep(one / square_root((one - a.value) * (one + a.value)));
    return chain(elementary(Elementary::Acos, a.value), -steepness, a);
}

template <class Real>
Dual<Real> exp(const Dual<Real>& a) {
    const Real value = elementary(Elementary::Exp, a.value);
    return chain(value, value, a);
}

template <class Real>
Dual<Real> log(const Dual<Real>& a) {
    return chain(elementary(Elementary::Log, a.value), like(a.value, 1.0) / a.value, a);
}

template <class Real>
Dual<Real> log10(const Dual<Real>& a) {
    const Real scale = like(a.value, format_of(a.value).per_ln10);
    return chain(elementary(Elementary::Log10, a.value), scale / a.value, a);
}

template <class Real>
Dual<Real> log2(const Dual<Real>& a) {
    const Real scale = like(a.value, format_of(a.value).per_ln2);
    return chain(elementary(Elementary::Log2, a.value), scale / a.value, a);
}

template <class Real>
Dual<Real> atan2(const Dual<Real>& y, const Dual<Real>& x) {
    const Real radius2 = x.value * x.value + y.value * y.value;
    return chain(elementary(Elementary::Atan2, y.value, x.value), x.value / radius2, y,
                 -(y.value / radius2), x);
}

/// sin(n atan2(y, x)); NaN at the origin.
template <class Real>
Dual<Real> angle_sin(const Dual<Real>& y, const Dual<Real>& x, int n) {
    const PolarPoint<Real> p = polar_point(y.value, x.value);
    const Complex<Real> wave = power(p.direction, n);
    const Real slope = like(wave.re, n) * p.per_length * wave.re;
    return chain(wave.im, slope * p.direction.re, y, -(slope * p.direction.im), x);
}

template <class Real>
Dual<Real> angle_cos(const Dual<Real>& y, const Dual<Real>& x, int n) {
    const PolarPoint<Real> p = polar_point(y.value, x.value);
    const Complex<Real> wave = power(p.direction, n);
    const Real slope = like(wave.re, n) * p.per_length * wave.im;
    return chain(wave.re, -(slope * p.direction.re), y, slope * p.direction.im, x);
}

template <class Real>
Dual<Real> length(const Dual<Real>& y, const Dual<Real>& x) {
    const PolarPoint<Real> p = polar_point(y.value, x.value);
    const Real per_length = at_most_steep(p.per_length);  // finite, so 0 times it is 0
    return chain(p.length, y.value * per_length, y, x.value * per_length, x);
}

template <class Real>
Dual<Real> cardinal(Cardinal function, const Dual<Real>& a) {
    const Real& x = a.value;
    const Real one = like(x, 1.0);
    const Real value = cardinal_at(function, x, elementary(dividend(function), x));
    const Real slope = function == Cardinal::Sin    ? elementary(Elementary::Cos, x)
                       : function == Cardinal::Sinh ? elementary(Elementary::Cosh, x)
                                                    : one / (one + x * x);
    return chain(value, cardinal_slope_at(function, x, value, slope), a);
}

template <class Real>
Dual<Real> tan(const Dual<Real>& a) {
    const Real value = elementary(Elementary::Tan, a.value);
    return chain(value, like(value, 1.0) + value * value, a);
}

template <class Real>
Dual<Real> cot(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    const Real value = one / elementary(Elementary::Tan, a.value);
    return chain(value, -(one + value * value), a);
}

template <class Real>
Dual<Real> asin(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    return chain(elementary(Elementary::Asin, a.value),
                 at_most_steep(one / square_root((one - a.value) * (one + a.value))), a);
}

template <class Real>
Dual<Real> atan(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    return chain(elementary(Elementary::Atan, a.value), one / (one + a.value * a.value), a);
}

template <class Real>
Dual<Real> sinh(const Dual<Real>& a) {
    return chain(elementary(Elementary::Sinh, a.value), elementary(Elementary::Cosh, a.value), a);
}

template <class Real>
Dual<Real> cosh(const Dual<Real>& a) {
    return chain(elementary(Elementary::Cosh, a.value), elementary(Elementary::Sinh, a.value), a);
}

template <class Real>
Dual<Real> tanh(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    const Real value = elementary(Elementary::Tanh, a.value);
    return chain(value, (one - value) * (one + value), a);
}

template <class Real>
Dual<Real> asinh(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    return chain(elementary(Elementary::Asinh, a.value), one / square_root(one + a.value * a.value),
                 a);
}

template <class Real>
Dual<Real> acosh(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    return chain(elementary(Elementary::Acosh, a.value),
                 at_most_steep(one / square_root((a.value - one) * (a.value + one))), a);
}

template <class Real>
Dual<Real> atanh(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    return chain(elementary(Elementary::Atanh, a.value), one / ((one - a.value) * (one + a.value)),
                 a);
}

/// n-th root of `size` >= 0 from its logarithm, corrected by one step of Newton's method; 0 and
/// +inf are returned unchanged.
template <class Real>
Real point_odd_root(const Real& size, int n) {
    if (n == 3) return elementary(Elementary::Cbrt, size);
    const Real degree = like(size, n);
    const Real root = elementary(Elementary::Exp, elementary(Elementary::Log, size) / degree);
    const Real zero = like(size, 0.0);
    const Real step = root * (size / point_power(root, n) - like(size, 1.0)) / degree;
    const auto tiny = magnitude(step) < root;  // false near 0 and +inf, where the step is NaN
    return root + select(tiny, step, zero);
}

/// The real n-th root, for odd n >= 3.
template <class Real>
Dual<Real> odd_root(const Dual<Real>& a, int n) {
    const Real size = point_odd_root(magnitude(a.value), n);
    const Real value = select_negative(a.value, -size, size);
    const Real steepness = like(size, 1.0) / (like(size, n) * point_power(size, n - 1));
    return chain(value, at_most_steep(steepness), a);
}

/// a - b k with k = floor(a/b), which is treated as constant.
template <class Real>
Dual<Real> mod(const Dual<Real>& a, const Dual<Real>& b) {
    const Real k = round_down(a.value / b.value);
    return chain(a.value - b.value * k, like(k, 1.0), a, -k, b);
}

template <class Mask, class Real>
Dual<Real> select_dual(const Mask& condition, const Dual<Real>& a, const Dual<Real>& b) {
    Dual<Real> result{select(condition, a.value, b.value), {}};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!a.slope.has(i) && !b.slope.has(i)) continue;
        const Real zero = like(a.value, 0.0);
        const Real in_a = a.slope.has(i) ? a.slope.known(i) : zero;
        const Real in_b = b.slope.has(i) ? b.slope.known(i) : zero;
        result.slope.set(i, select(condition, in_a, in_b));
    }
    return result;
}

template <class Real>
Dual<Real> min(const Dual<Real>& a, const Dual<Real>& b) {
    return select_dual(a.value < b.value, a, b);
}

template <class Real>
Dual<Real> max(const Dual<Real>& a, const Dual<Real>& b) {
    return select_dual(a.value > b.value, a, b);
}

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// a where the condition's value is above 0, b elsewhere; NaN where the condition is.
template <class Real>
Dual<Real> choose(const Real& condition, const Dual<Real>& a, const Dual<Real>& b) {
    Dual<Real> result = select_dual(condition > like(condition, 0.0), a, b);
    result.value = select(unordered(condition, condition), condition, result.value);
    return result;
}

/// a where b is above 0, -a where it is below, NaN elsewhere.
template <class Real>
Dual<Real> oriented(const Dual<Real>& a, const Real& b) {
    const Real zero = like(b, 0.0);
    const auto below = b < zero;
    Dual<Real> result = select_dual(below, -a, a);
    const auto known = either(below, b > zero);
    result.value = select(known, result.value, like(b, not_a_number));
    return result;
}

/// a where the condition's value is above 0, NaN elsewhere.
template <class Real>
Dual<Real> where(const Dual<Real>& a, const Real& condition) {
    const auto holds = condition > like(condition, 0.0);
    return {select(holds, a.value, like(a.value, not_a_number)), a.slope};
}

}  // namespace zeroset
