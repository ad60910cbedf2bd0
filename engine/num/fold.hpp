#pragma once

#include "engine/num/dual.hpp"
#include "engine/num/interval.hpp"
#include "engine/num/steps.hpp"

// Distance from the nearest even integer, a continuous triangle wave from 0 to 1: |a - n| for the
// nearest integer n where n is even, 1 - |a - n| where n is odd.

namespace zeroset {

/// The integer n nearest to a number, and whether n is odd.
template <class Real>
struct FoldAt {
    Real n;
    decltype(std::declval<Real>() > std::declval<Real>()) odd;
};

template <class Real>
FoldAt<Real> fold_at(const Real& a) {
    const Real n = nearest_integer(a);
    const Real half = like(a, 0.5);
    return {n, n * half - round_down(n * half) > like(a, 0.25)};
}

/// Range of the fold over `a`, in upward rounding.
template <class Real>
Interval<Real> fold(const Interval<Real>& a) {
    const Real half = like(a.hi, 0.5);
    const Real one = like(a.hi, 1.0);
    // Measure `a` from the integer nearest to its middle.
    const auto [n, odd] = fold_at(a.hi * half - a.neg_lo * half);
    const Interval<Real> v{a.neg_lo + n, a.hi - n};
    const Interval<Real> size = absolute(v);
    const Interval<Real> turned{size.hi - one, size.neg_lo + one};
    const auto within_reach = both(v.neg_lo <= one, v.hi <= one);  // false where NaN
    const Interval<Real> all{like(one, 0.0), one};
    return select(within_reach, select(odd, turned, size), all);
}

template <class Real>
Dual<Real> fold(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    const auto [n, odd] = fold_at(a.value);
    const Real v = a.value - n;
    const Real size = magnitude(v);
    const Real slope = select_negative(v, -one, one);
    return chain(select(odd, one - size, size), select(odd, -slope, slope), a);
}

}  // namespace zeroset
