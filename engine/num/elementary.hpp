#pragma once

#include "engine/num/interval.hpp"
#include "engine/num/sleef.hpp"

#include <limits>
#include <numbers>

// Intervals of elementary functions over any carrier, in upward rounding. Library results are
// taken in round-to-nearest and widened by their error bound.

namespace zeroset {

/// The range of a function with a domain.
template <class Real, class Mask>
struct PartialRange {
    Interval<Real> value;
    Mask defined;     ///< false: undefined on the whole box
    Mask continuous;  ///< true: proved defined and continuous on the whole box
};

/// The range of a function that is defined everywhere but jumps.
template <class Real, class Mask>
struct JumpingRange {
    Interval<Real> value;
    Mask continuous;  ///< true: proved continuous on the whole box
};

inline double smallest_normal(float /*kind*/) {
    return static_cast<double>(std::numeric_limits<float>::min());
}
inline double smallest_normal(double /*kind*/) { return std::numeric_limits<double>::min(); }
inline double largest_finite(float /*kind*/) {
    return static_cast<double>(std::numeric_limits<float>::max());
}
inline double largest_finite(double /*kind*/) { return std::numeric_limits<double>::max(); }

/// Bound of |true - result| for a library result, denormals included.
template <class Real>
Real library_error(Elementary function, const Real& result) {
    const double relative = elementary_bound_ulp(function) * 0.5 * relative_gap(result);
    return magnitude(result) * like(result, relative) + like(result, smallest_normal(result));
}

/// [a, b] for library results a <= b up to their errors.
template <class Real>
Interval<Real> widened(Elementary function, const Real& a, const Real& b) {
    const Real finite = minimum(a, like(a, largest_finite(a)));  // exp may round a finite value up
    return {library_error(function, finite) - finite, b + library_error(function, b)};
}

template <class Real>
Interval<Real> clamped(const Interval<Real>& a, double lo, double hi) {
    return {minimum(a.neg_lo, like(a.hi, -lo)), minimum(a.hi, like(a.hi, hi))};
}

/// Whether (conservatively) some phase + 2 pi k lies in a. `phase_lo <= phase <= phase_hi`.
template <class Real>
auto meets_phase(const Interval<Real>& a, double phase_lo, double phase_hi) {
    constexpr double turns_per_radian = 0x1.45f306p-3;  // the float nearest to 1 / (2 pi)
    const Real turns = like(a.hi, turns_per_radian);
    const Real slack = like(a.hi, 0x1p-21);  // above the error of turns and of both products
    const Real above = a.hi + like(a.hi, -phase_lo);
    const Real below = a.neg_lo + like(a.hi, phase_hi);
    const Real turns_above = above * turns + magnitude(above) * slack;
    const Real turns_neg_below = below * turns + magnitude(below) * slack;
    return round_down(turns_above) + turns_neg_below >= like(a.hi, 0.0);
}

/// sin or cos, whose maxima are at `phase` + 2 pi k and minima half a turn away; the phases are
/// given as float-representable enclosures.
template <class Real>
Interval<Real> wave(Elementary function, const Interval<Real>& a, double max_lo, double max_hi,
                    double min_lo, double min_hi) {
    const Real first = elementary(function, -a.neg_lo);
    const Real last = elementary(function, a.hi);
    const Interval<Real> ends = widened(function, minimum(first, last), maximum(first, last));
    const Real one = like(a.hi, 1.0);
    const Real far = like(a.hi, 0x1p20);  // beyond, a period is a few hundred thousand ulp or less
    const auto near = both(a.neg_lo <= far, a.hi <= far);
    const Interval<Real> bounded = clamped(ends, -1.0, 1.0);
    return {select(both(near, no(meets_phase(a, min_lo, min_hi))), bounded.neg_lo, one),
            select(both(near, no(meets_phase(a, max_lo, max_hi))), bounded.hi, one)};
}

// Floats around pi and its half.
inline constexpr double pi_lo = 0x1.921fb4p+1, pi_hi = 0x1.921fb6p+1;
static_assert(pi_lo < std::numbers::pi && std::numbers::pi < pi_hi);

template <class Real>
Interval<Real> sin(const Interval<Real>& a) {
    return wave(Elementary::Sin, a, 0.5 * pi_lo, 0.5 * pi_hi, -0.5 * pi_hi, -0.5 * pi_lo);
}

template <class Real>
Interval<Real> cos(const Interval<Real>& a) {
    return wave(Elementary::Cos, a, 0.0, 0.0, pi_lo, pi_hi);
}

template <class Real>
auto acos(const Interval<Real>& a) {
    const Real one = like(a.hi, 1.0);
    const Real lo = maximum(-a.neg_lo, -one);
    const Real hi = minimum(a.hi, one);
    const Interval<Real> value = clamped(widened(Elementary::Acos, elementary(Elementary::Acos, hi),
                                                 elementary(Elementary::Acos, lo)),
                                         0.0, pi_hi);
    return PartialRange{value, both(lo <= one, hi >= -one), both(a.neg_lo <= one, a.hi <= one)};
}

template <class Real>
Interval<Real> exp(const Interval<Real>& a) {
    const Interval<Real> value = widened(Elementary::Exp, elementary(Elementary::Exp, -a.neg_lo),
                                         elementary(Elementary::Exp, a.hi));
    return {minimum(value.neg_lo, like(a.hi, 0.0)), value.hi};
}

template <class Real>
auto log(const Interval<Real>& a) {
    const Real zero = like(a.hi, 0.0);
    const Real lo = maximum(-a.neg_lo, zero);
    const Interval<Real> value = widened(Elementary::Log, elementary(Elementary::Log, lo),
                                         elementary(Elementary::Log, maximum(a.hi, zero)));
    return PartialRange{without_nan(value), a.hi > zero, a.neg_lo < zero};
}

template <class Real>
auto sqrt(const Interval<Real>& a) {
    const Real zero = like(a.hi, 0.0);
    return PartialRange{square_root(a), a.hi >= zero, a.neg_lo <= zero};
}

/// The angle of (x, y) from the corners where it is extreme, for a box of the right half plane or
/// one that does not meet the x axis.
template <class Real>
Interval<Real> angle_from_corners(const Interval<Real>& y, const Interval<Real>& x) {
    const Real zero = like(x.hi, 0.0);
    const Real x_lo = -x.neg_lo;
    const Real y_lo = -y.neg_lo;
    // Above the x axis the angle falls with x, below it grows; it grows with y where x > 0.
    const Real x_at_max = select(y.hi <= zero, x.hi, x_lo);
    const Real y_at_max = select(x_at_max > zero, y.hi, y_lo);
    const Real x_at_min = select(y_lo >= zero, x.hi, x_lo);
    const Real y_at_min = select(x_at_min > zero, y_lo, y.hi);
    return widened(Elementary::Atan2, elementary(Elementary::Atan2, y_at_min, x_at_min),
                   elementary(Elementary::Atan2, y_at_max, x_at_max));
}

/// What atan2 needs to know of its box.
template <class Mask>
struct AngleCases {
    Mask around_origin;  ///< the box meets the origin
    Mask across_cut;     ///< it meets the negative x axis but not the origin
};

template <class Real>
auto angle_cases(const Interval<Real>& y, const Interval<Real>& x) {
    const auto y_has_zero = contains_zero(y);
    const auto origin = both(y_has_zero, contains_zero(x));
    const auto cut = both(y_has_zero, x.hi < like(x.hi, 0.0));
    return AngleCases<decltype(contains_zero(y))>{origin, cut};
}

/// atan2(y, x): the whole circle, and not continuous, where the box meets its cut.
template <class Real>
auto atan2(const Interval<Real>& y, const Interval<Real>& x) {
    const auto cases = angle_cases(y, x);
    const auto cut = either(cases.around_origin, cases.across_cut);
    const Interval<Real> circle{like(x.hi, pi_hi), like(x.hi, pi_hi)};
    const Interval<Real> value = select(cut, circle, angle_from_corners(y, x));
    return JumpingRange{clamped(value, -pi_hi, pi_hi), no(cut)};
}

/// atan2(y, x) up to a multiple of 2 pi: continuous across the cut, where it goes on above pi.
template <class Real>
auto angle(const Interval<Real>& y, const Interval<Real>& x) {
    const auto cases = angle_cases(y, x);
    const auto cut = cases.across_cut;
    const Interval<Real> turned = angle_from_corners(select(cut, -y, y), select(cut, -x, x));
    const Real zero = like(x.hi, 0.0);
    const Interval<Real> half_turn{select(cut, like(zero, -pi_lo), zero),
                                   select(cut, like(zero, pi_hi), zero)};
    const Interval<Real> circle{like(x.hi, pi_hi), like(x.hi, pi_hi)};
    const Interval<Real> value = select(cases.around_origin, circle, turned + half_turn);
    return JumpingRange{value, no(cases.around_origin)};
}

}  // namespace zeroset
