#pragma once

#include "engine/num/periodic.hpp"
#include "engine/real/sleef.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

// sin(x)/x, sinh(x)/x and atan(x)/x, 1 at 0, over any carrier. Rewritten differences of sines, of
// exponentials and of angles contain them (engine/rewrite/differences/differences.hpp). All are
// even and smooth.

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

/// The numbers in both intervals; `b` has no NaN.
template <class Real>
Interval<Real> common(const Interval<Real>& a, const Interval<Real>& b) {
    return {minimum(a.neg_lo, b.neg_lo), minimum(a.hi, b.hi)};
}

/// Values of the function near 0 and far from it, at the ends of its |x|.
template <class Real>
struct CardinalEnds {
    Real near, far;
    Real error_near, error_far;

    /// From those of the dividend.
    CardinalEnds(Cardinal function, const Interval<Real>& size, const Real& f_near,
                 const Real& f_far)
        : near(cardinal_at(function, -size.neg_lo, f_near)),
          far(cardinal_at(function, size.hi, f_far)),
          error_near(error_of(near)),
          error_far(error_of(far)) {}

private:
    static Real error_of(const Real& value) {
        const Format& format = format_of(value);
        return magnitude(value) * like(value, 0.5 * cardinal_error_ulp * format.relative_gap) +
               like(value, format.smallest_normal);
    }
};

/// Range of sin(x)/x over x. It falls with |x| up to 4.4934, where it is -0.21723; beyond it is
/// below 0.12838.
template <class Real>
Interval<Real> sine_over(const Interval<Real>& size) {
    const auto number = [&](double value) { return like(size.hi, value); };
    const Real f_near = elementary(Elementary::Sin, -size.neg_lo);
    const Real f_far = elementary(Elementary::Sin, size.hi);
    const CardinalEnds<Real> ends(Cardinal::Sin, size, f_near, f_far);
    const auto falls = size.hi <= number(4.4375);  // false where NaN
    const Real highest = minimum(ends.near + ends.error_near, number(1));
    const Interval<Real> coarse{select(falls, ends.error_far - ends.far, number(0.21875)),
                                select(falls, highest, maximum(highest, number(0.12890625)))};
    return common(divide_by_nonnegative(sine_between(size, f_near, f_far), size), coarse);
}

/// Range of the function over x. sinh(x)/x rises with |x|, atan(x)/x falls.
template <class Real>
Interval<Real> cardinal(Cardinal function, const Interval<Real>& x) {
    const Interval<Real> size = absolute(x);
    if (function == Cardinal::Sin) return sine_over(size);
    const auto number = [&](double value) { return like(x.hi, value); };
    const Elementary top = dividend(function);
    // The library's sinh of a large operand may be infinite.
    const Real f_near =
        minimum(elementary(top, -size.neg_lo), number(format_of(x.hi).bound(top).overflow));
    const CardinalEnds<Real> ends(function, size, f_near, elementary(top, size.hi));
    const bool rises = function == Cardinal::Sinh;
    const Interval<Real> range =
        rises ? Interval<Real>{minimum(ends.error_near - ends.near, number(-1)),
                               ends.far + ends.error_far}
              : Interval<Real>{minimum(ends.error_far - ends.far, number(0)),
                               minimum(ends.near + ends.error_near, number(1))};
    const Interval<Real> all =
        rises ? Interval<Real>{number(-1), number(infinity)} : Interval<Real>{number(0), number(1)};
    return select(unordered(range.neg_lo, range.hi), all, range);
}

/// Bounds of the first two derivatives for |x| <= far; the first derivative lies in x * by_x.
template <class Real>
struct CardinalBends {
    Interval<Real> by_x, second;
};

/// The bounds that are tight near 0.
template <class Real>
CardinalBends<Real> bends_near_zero(Cardinal function, const Interval<Real>& x) {
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
    return {{first.neg_lo, minimum(by_x, number(sine ? 0.03125 : 0.0))},
            {first.neg_lo, minimum(second, number(sine ? 0.25 : 0.125))}};
}

/// Range of the first derivative over x, from the function's own range g: (f' - g)/x for the
/// dividend f.
template <class Real>
Interval<Real> cardinal_slope(Cardinal function, const Interval<Real>& x, const Interval<Real>& g) {
    const auto slope_of_dividend = [&] {
        const Interval<Real> one = point(like(x.hi, 1));
        if (function == Cardinal::Sin) return cos(x);
        if (function == Cardinal::Sinh) return cosh(x);
        return one / (one + power_nonnegative(absolute(x), 2));
    };
    return common((slope_of_dividend() - g) / x, bends_near_zero(function, x).by_x * x);
}

/// Range of the second derivative over x, from those of the function and of the first one:
/// (f'' - 2 slope)/x for the dividend f.
template <class Real>
Interval<Real> cardinal_bend(Cardinal function, const Interval<Real>& x, const Interval<Real>& g,
                             const Interval<Real>& slope) {
    const auto bend_of_dividend_by_x = [&] {
        if (function == Cardinal::Sin) return -g;
        if (function == Cardinal::Sinh) return g;
        const Interval<Real> one = point(like(x.hi, 1));
        const Interval<Real> below = one + power_nonnegative(absolute(x), 2);
        return scale(one / power_nonnegative(below, 2), -2.0);
    };
    return common(bend_of_dividend_by_x() - scale(slope, 2.0) / x,
                  bends_near_zero(function, x).second);
}

}  // namespace zeroset
