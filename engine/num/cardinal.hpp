#pragma once

#include "engine/num/elementary.hpp"
#include "engine/real/sleef.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

// sin(x)/x, sinh(x)/x and atan(x)/x, 1 at 0, over any carrier. Rewritten differences of sines, of
// exponentials and of angles contain them (engine/rewrite/differences/differences.hpp). All are
// even and smooth; the bounds of their derivatives are tight near 0, where differences need them.

namespace zeroset {

enum class Cardinal : std::uint8_t { Sin, Sinh, Atan };

/// The function that is divided by its operand.
constexpr Elementary dividend(Cardinal function) {
    switch (function) {
        case Cardinal::Sin: return Elementary::Sin;
        case Cardinal::Sinh: return Elementary::Sinh;
        case Cardinal::Atan: return Elementary::Atan;
    }
    return Elementary::Sin;
}

/// The power series are used for x^2 below this.
inline constexpr double series_ends_at_square = 0x1p-6;

/// Coefficients of a power series, as doubles and as the nearest floats. They are converted at
/// compile time, as a conversion at run time would depend on the rounding mode.
template <std::size_t count>
struct Coefficients {
    std::array<double, count> exact;
    std::array<double, count> floats;

    consteval explicit Coefficients(const std::array<double, count>& values)
        : exact(values), floats() {
        for (std::size_t i = 0; i < count; ++i)
            floats[i] = static_cast<double>(static_cast<float>(values[i]));
    }
    [[nodiscard]] constexpr double at(std::size_t i, RealType type) const {
        return type == RealType::Float ? floats[i] : exact[i];
    }
};

/// c[0] + c[1] t + c[2] t^2 + ...
template <class Real, std::size_t count>
Real series(const Coefficients<count>& c, const Real& t) {
    const RealType type = format_of(t).type;
    Real sum = like(t, c.at(count - 1, type));
    for (std::size_t k = count - 1; k-- > 0;)
        sum = like(t, c.at(k, type)) + t * sum;
    return sum;
}

/// Power series of the function in t = x^2; the omitted terms are below 2^-56.
template <class Real>
Real cardinal_series(Cardinal function, const Real& t) {
    static constexpr Coefficients sine{
        std::array{1.0, -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800}};
    static constexpr Coefficients hyperbolic{
        std::array{1.0, 1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800}};
    static constexpr Coefficients arc{std::array{1.0, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9,
                                                 -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17,
                                                 -1.0 / 19}};
    switch (function) {
        case Cardinal::Sin: return series(sine, t);
        case Cardinal::Sinh: return series(hyperbolic, t);
        case Cardinal::Atan: return series(arc, t);
    }
    return t;
}

/// Error bound of `cardinal_at` in ulp, in any rounding mode.
inline constexpr double cardinal_error_ulp = 8.0;

/// Value of the function at x, not rounded outward; `f` is the library's value of the dividend.
template <class Real>
Real cardinal_at(Cardinal function, const Real& x, const Real& f) {
    const Real t = x * x;
    const auto small = t < like(t, series_ends_at_square);
    return select(small, cardinal_series(function, t), f / x);
}

/// Derivative of the function at x, not rounded outward; `value` is the function's value, `df` the
/// derivative of the dividend.
template <class Real>
Real cardinal_slope_at(Cardinal function, const Real& x, const Real& value, const Real& df) {
    static constexpr Coefficients sine{std::array{-1.0 / 3, 1.0 / 30, -1.0 / 840, 1.0 / 45360}};
    static constexpr Coefficients hyperbolic{std::array{1.0 / 3, 1.0 / 30, 1.0 / 840, 1.0 / 45360}};
    static constexpr Coefficients arc{
        std::array{-2.0 / 3, 4.0 / 5, -6.0 / 7, 8.0 / 9, -10.0 / 11, 12.0 / 13}};
    const Real t = x * x;
    const auto small = t < like(t, series_ends_at_square);
    const Real by_x = function == Cardinal::Sin    ? series(sine, t)
                      : function == Cardinal::Sinh ? series(hyperbolic, t)
                                                   : series(arc, t);
    return select(small, x * by_x, (df - value) / x);
}

/// Range of the function over x. It is monotone in |x|, except that sin(x)/x for |x| > 3 is only
/// known to be small.
template <class Real>
Interval<Real> cardinal(Cardinal function, const Interval<Real>& x) {
    const Elementary top = dividend(function);
    const Interval<Real> size = absolute(x);
    const Real near = -size.neg_lo;
    const Real far = size.hi;
    const Format& format = format_of(far);
    const auto number = [&](double value) { return like(far, value); };
    const auto value_at = [&](const Real& at, double most) {
        // The library's sinh of a large operand may be infinite.
        const Real f = minimum(elementary(top, at), number(most));
        return cardinal_at(function, at, f);
    };
    const auto widened_by = [&](const Real& value) {
        return value * number(0.5 * cardinal_error_ulp * format.relative_gap) +
               number(format.smallest_normal);
    };
    // sinh(x)/x rises with |x|; the others fall, sin(x)/x up to |x| = 3.
    if (function == Cardinal::Sinh) {
        const Real lowest = value_at(near, format.bound(top).overflow);
        const Real highest = value_at(far, infinity);
        const Real neg_lo = minimum(widened_by(lowest) - lowest, number(-1));
        const Interval<Real> range{neg_lo, highest + widened_by(highest)};
        return select(unordered(range.neg_lo, range.hi),
                      Interval<Real>{number(-1), number(infinity)}, range);
    }
    const Real highest = value_at(near, infinity);
    const Real lowest = value_at(far, infinity);
    const Real hi = minimum(highest + widened_by(magnitude(highest)), number(1));
    const Real neg_lo = widened_by(magnitude(lowest)) - lowest;
    if (function == Cardinal::Atan) {
        const Interval<Real> range{minimum(neg_lo, number(0)), hi};
        return select(unordered(range.neg_lo, range.hi), Interval<Real>{number(0), number(1)},
                      range);
    }
    const auto monotone = far <= number(3);  // false where NaN
    const auto small = near > number(3);
    const Real quarter = number(0.25);
    return {select(monotone, neg_lo, quarter),
            select(monotone, hi, select(small, quarter, number(1)))};
}

/// Bounds of the first two derivatives for |x| <= far; the first derivative lies in x * by_x.
template <class Real>
struct CardinalBends {
    Interval<Real> by_x, second;
};

template <class Real>
CardinalBends<Real> cardinal_bends(Cardinal function, const Interval<Real>& x) {
    const auto number = [&](double value) { return like(x.hi, value); };
    const Real far = absolute(x).hi;
    const Real square = far * far;
    const Interval<Real> third = point(number(1)) / point(number(3));
    if (function == Cardinal::Sinh) {
        const Interval<Real> all = multiply_nonnegative(third, cosh(Interval<Real>{far, far}));
        const Interval<Real> both_ways{third.neg_lo, all.hi};
        return {both_ways, both_ways};
    }
    // Near 0 the series alternate, so two terms bound them from above; elsewhere a constant does.
    const bool sine = function == Cardinal::Sin;
    const Interval<Real> first = sine ? -third : -(third + third);
    const Real by_x = first.hi + square * number(sine ? 0.0625 : 0.8125);
    const Real second = first.hi + square * number(sine ? 0.125 : 2.5);
    return {{first.neg_lo, minimum(by_x, number(sine ? 0.5 : 0.0))},
            {first.neg_lo, minimum(second, number(0.5))}};
}

}  // namespace zeroset
