#pragma once

#include "engine/num/elementary.hpp"

// The real n-th root of odd n over any carrier, in upward rounding.

namespace zeroset {

/// Encloses the n-th root of a > 0, for n >= 3.
//
// R = exp(log(a) / n) is an enclosure by construction, but wide: the error of log(a), a few ulp of
// up to 104 (float) or 745 (double), becomes a relative error of the root. One step of Newton's
// method in intervals reduces the width to a few ulp: for f(r) = r^n - a and any m, the mean value
// theorem puts every root r of f in R at r = m - f(m) / f'(s), with an s between m and r. If m is
// in R, so is s. So the root is in m + (a - m^n) / (n R^(n-1)), each operation rounded outward,
// and in R.
//
// The result's width is that of m^n, 2 (n-1) roundings, divided by n, plus the product of the
// relative widths of R and of R^(n-1): for floats below 2^-15 and 2^-14, for doubles 2^-41 and
// 2^-40. Where a power leaves the normal range, R alone is the result.
template <class Real>
Interval<Real> positive_odd_root(const Real& a, int n) {
    const Real log_a = elementary(Elementary::Log, a);
    const Real degree = like(a, n);
    const Interval<Real> log_box = widened(Elementary::Log, log_a, log_a);
    const Interval<Real> root = exp(Interval<Real>{log_box.neg_lo / degree, log_box.hi / degree});
    const Real middle = (root.hi - root.neg_lo) * like(a, 0.5);
    const Interval<Real> missing = point(a) - power_nonnegative(point(middle), n);
    const Interval<Real> slope = scale(power_nonnegative(root, n - 1), n);
    const Interval<Real> newton = point(middle) + missing / slope;
    // Where the Newton step is NaN, minimum returns its second argument, the end of `root`.
    return {minimum(newton.neg_lo, root.neg_lo), minimum(newton.hi, root.hi)};
}

/// Upper bound of the real n-th root of `a`, for odd n >= 3.
template <class Real>
Real odd_root_up(const Real& a, int n) {
    const Real zero = like(a, 0.0);
    if (n == 3) return select(a == zero, zero, odd_up(Elementary::Cbrt, a));
    const Interval<Real> size = positive_odd_root(magnitude(a), n);
    return select(a == zero, zero, select(a < zero, size.neg_lo, size.hi));
}

template <class Real>
Interval<Real> odd_root(const Interval<Real>& a, int n) {
    return {odd_root_up(a.neg_lo, n), odd_root_up(a.hi, n)};
}

}  // namespace zeroset
