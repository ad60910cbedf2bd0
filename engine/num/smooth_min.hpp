#pragma once

#include "engine/num/dual.hpp"
#include "engine/num/interval.hpp"

// The quadratic blend of width 1 over any carrier: min(a, b) - h^2/4 with h = max(1 - |a - b|, 0).
// With d = a - b it is b + g(d), where g is concave and increasing: d for d <= -1, -(1 - d)^2/4
// from -1 to 1, and 0 for d >= 1. Its derivatives by a and b are shares: nonnegative, with the sum
// 1.

namespace zeroset {

/// Range of the blend, in upward rounding. The blend increases with both operands, so its ends
/// follow from theirs.
template <class Real>
Interval<Real> smooth_min(const Interval<Real>& a, const Interval<Real>& b) {
    const auto number = [&](double value) { return like(a.hi, value); };
    const Real zero = number(0);
    // Lower bound of |a - b| at the lower ends; 0 where both are -inf and the difference is NaN.
    const Real above_lo = b.neg_lo - a.neg_lo;
    const Real below_lo = a.neg_lo - b.neg_lo;
    const Real least = select(unordered(above_lo, below_lo), zero, maximum(-above_lo, -below_lo));
    const Real most_height = maximum(number(1) - least, zero);
    // Upper bound of |a - b| at the upper ends; +inf where the difference is NaN.
    const Real above_hi = a.hi - b.hi;
    const Real below_hi = b.hi - a.hi;
    const Real most =
        select(unordered(above_hi, below_hi), number(infinity), maximum(above_hi, below_hi));
    const Real neg_height = minimum(most - number(1), zero);
    const Interval<Real> lesser = minimum(a, b);
    return {lesser.neg_lo + number(0.25) * most_height * most_height,
            lesser.hi + number(0.25) * (neg_height * -neg_height)};
}

template <class Real>
Dual<Real> smooth_min(const Dual<Real>& a, const Dual<Real>& b) {
    const Real one = like(a.value, 1.0);
    const Real zero = like(a.value, 0.0);
    const Real half = like(a.value, 0.5);
    const Real d = a.value - b.value;
    const Real distance = magnitude(d);
    const auto apart = distance >= one;  // false where NaN
    const Real height = select(apart, zero, one - distance);
    const auto first = a.value < b.value;
    const Real value = select(first, a.value, b.value) - like(one, 0.25) * height * height;
    const Real share = select(apart, select(first, one, zero), half - half * d);
    return chain(value, share, a, one - share, b);
}

}  // namespace zeroset
