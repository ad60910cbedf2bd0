#pragma once

#include "engine/num/enclosure.hpp"
#include "engine/real/sleef.hpp"

// Intervals of elementary functions over any carrier, in upward rounding. Library results are taken
// in round-to-nearest and widened by their error bound. A partial function's range is the image of
// the part of the box inside its domain. Masks that say where something surely is not are negations
// of comparisons, so an unknown operand (interval.hpp), which fails every comparison, proves
// nothing.

namespace zeroset {

/// Upper bound of |true value - result| for a library result, denormals included.
template <class Real>
Real library_error(Elementary function, const Real& result) {
    const Format& format = format_of(result);
    const double relative = format.bound(function).ulp * 0.5 * format.relative_gap;
    return magnitude(result) * like(result, relative) + like(result, format.smallest_normal);
}

/// Encloses [a, b] for library results, a <= b up to their errors; the whole line where one is NaN.
template <class Real>
Interval<Real> widened(Elementary function, const Real& a, const Real& b) {
    // exp may round a finite value up.
    const Real finite = minimum(like(a, format_of(a).largest_finite), a);
    return without_nan<Real>(
        {library_error(function, finite) - finite, b + library_error(function, b)});
}

template <class Real>
Interval<Real> clamped(const Interval<Real>& a, double lo, double hi) {
    return {minimum(a.neg_lo, like(a.hi, -lo)), minimum(a.hi, like(a.hi, hi))};
}

/// Upper bound of the odd increasing library function at `a`. Its lower bound at `lo` is the
/// negated upper bound at -lo.
template <class Real>
Real odd_up(Elementary function, const Real& a) {
    const Real result = elementary(function, a);
    const Format& format = format_of(result);
    const auto too_low = result < like(result, -format.largest_finite);
    const Real overflow = like(result, -format.bound(function).overflow);
    const Real finite = select(too_low, overflow, result);
    return finite + library_error(function, finite);
}

template <class Real>
Interval<Real> odd_increasing(Elementary function, const Interval<Real>& a) {
    return {odd_up(function, a.neg_lo), odd_up(function, a.hi)};
}

/// The interval of `widened`, for a function whose library results overflow before its true values.
template <class Real>
Interval<Real> widened_over(Elementary function, const Real& a, const Real& b) {
    const Format& format = format_of(a);
    const auto too_high = a > like(a, format.largest_finite);
    const Real finite = select(too_high, like(a, format.bound(function).overflow), a);
    return widened(function, finite, b);
}

template <class Real>
Interval<Real> exp(const Interval<Real>& a) {
    const Interval<Real> value = widened(Elementary::Exp, elementary(Elementary::Exp, -a.neg_lo),
                                         elementary(Elementary::Exp, a.hi));
    return {minimum(value.neg_lo, like(a.hi, 0.0)), value.hi};
}

/// Enclosure of Log, Log10 or Log2.
template <class Real>
Enclosure<Real> logarithm(Elementary function, const Interval<Real>& a) {
    const Real zero = like(a.hi, 0.0);
    const Real lo = maximum(-a.neg_lo, zero);
    const Interval<Real> value =
        widened(function, elementary(function, lo), elementary(function, maximum(a.hi, zero)));
    return {value, no(a.hi <= zero), a.neg_lo < zero};
}

template <class Real>
Enclosure<Real> sqrt(const Interval<Real>& a) {
    const Real zero = like(a.hi, 0.0);
    return {square_root(a), no(a.hi < zero), a.neg_lo <= zero};
}

template <class Real>
Enclosure<Real> asin(const Interval<Real>& a) {
    const Real one = like(a.hi, 1.0);
    const Interval<Real> inside{minimum(a.neg_lo, one), minimum(a.hi, one)};
    const double most = 0.5 * format_of(one).pi_hi;
    const Interval<Real> value = clamped(odd_increasing(Elementary::Asin, inside), -most, most);
    return {value, no(either(a.hi < -one, a.neg_lo < -one)), both(a.neg_lo <= one, a.hi <= one)};
}

template <class Real>
Enclosure<Real> acos(const Interval<Real>& a) {
    const Real one = like(a.hi, 1.0);
    const Real lo = maximum(-a.neg_lo, -one);
    const Real hi = minimum(a.hi, one);
    const Interval<Real> value = clamped(widened(Elementary::Acos, elementary(Elementary::Acos, hi),
                                                 elementary(Elementary::Acos, lo)),
                                         0.0, format_of(one).pi_hi);
    return {value, both(lo <= one, hi >= -one), both(a.neg_lo <= one, a.hi <= one)};
}

template <class Real>
Interval<Real> atan(const Interval<Real>& a) {
    const double most = 0.5 * format_of(a.hi).pi_hi;
    return clamped(odd_increasing(Elementary::Atan, a), -most, most);
}

template <class Real>
Interval<Real> cosh(const Interval<Real>& a) {
    const Interval<Real> size = absolute(a);
    const Interval<Real> value =
        widened_over(Elementary::Cosh, elementary(Elementary::Cosh, -size.neg_lo),
                     elementary(Elementary::Cosh, size.hi));
    return {minimum(value.neg_lo, like(a.hi, -1.0)), value.hi};
}

template <class Real>
Interval<Real> tanh(const Interval<Real>& a) {
    return clamped(odd_increasing(Elementary::Tanh, a), -1.0, 1.0);
}

template <class Real>
Enclosure<Real> acosh(const Interval<Real>& a) {
    const Real one = like(a.hi, 1.0);
    const Interval<Real> value =
        widened_over(Elementary::Acosh, elementary(Elementary::Acosh, maximum(one, -a.neg_lo)),
                     elementary(Elementary::Acosh, maximum(one, a.hi)));
    return {{minimum(value.neg_lo, like(a.hi, 0.0)), value.hi}, no(a.hi < one), a.neg_lo <= -one};
}

template <class Real>
Enclosure<Real> atanh(const Interval<Real>& a) {
    const Real one = like(a.hi, 1.0);
    const Interval<Real> inside{minimum(a.neg_lo, one), minimum(a.hi, one)};
    return {odd_increasing(Elementary::Atanh, inside), no(either(a.hi <= -one, a.neg_lo <= -one)),
            both(a.neg_lo < one, a.hi < one)};
}

}  // namespace zeroset
