#pragma once

#include "engine/num/elementary.hpp"

// Intervals of periodic functions and of angles over any carrier, in upward rounding.

namespace zeroset {

/// Where phase + k / frequency may lie in `a` for some integer k; never false where it does.
/// `phase_lo <= phase <= phase_hi`, numbers of the format; the frequency is `periods_a_turn`, 1 or
/// 2, for each turn.
//
// Both ends of `a` are measured from the phase in periods; a k exists if the last integer up to
// the upper end is not below the lower end. All sums and products are rounded upward, which makes
// them too high, the safe side. Only the frequency may be too low beside a positive factor, or too
// high beside a negative one, by less than the slack.
template <class Real>
auto meets_phase(const Interval<Real>& a, int periods_a_turn, double phase_lo, double phase_hi) {
    const Format& format = format_of(a.hi);
    const Real turns = like(a.hi, periods_a_turn * format.turns_per_radian);
    const Real slack = like(a.hi, format.turns_slack);
    const Real above = a.hi + like(a.hi, -phase_lo);
    const Real below = a.neg_lo + like(a.hi, phase_hi);
    const Real turns_above = above * turns + magnitude(above) * slack;
    const Real turns_neg_below = below * turns + magnitude(below) * slack;
    return round_down(turns_above) + turns_neg_below >= like(a.hi, 0.0);
}

/// Where `a` is near enough to 0 for phases to be told apart (Format::far).
template <class Real>
auto near_zero(const Interval<Real>& a) {
    const Real far = like(a.hi, format_of(a.hi).far);
    return both(a.neg_lo <= far, a.hi <= far);
}

/// Range of sin or cos, from the library's values at the ends of `a`. The maxima are at max + 2 pi
/// k, the minima at min + 2 pi k; both phases are given as enclosures by numbers of the format.
template <class Real>
Interval<Real> wave(Elementary function, const Interval<Real>& a, const Real& first,
                    const Real& last, double max_lo, double max_hi, double min_lo, double min_hi) {
    const Interval<Real> ends = widened(function, minimum(first, last), maximum(first, last));
    const Real one = like(a.hi, 1.0);
    const auto near = near_zero(a);
    const Interval<Real> bounded = clamped(ends, -1.0, 1.0);
    return {select(both(near, no(meets_phase(a, 1, min_lo, min_hi))), bounded.neg_lo, one),
            select(both(near, no(meets_phase(a, 1, max_lo, max_hi))), bounded.hi, one)};
}

/// Range of sin, from the library's values at the ends of `a`.
template <class Real>
Interval<Real> sine_between(const Interval<Real>& a, const Real& first, const Real& last) {
    const double lo = 0.5 * format_of(a.hi).pi_lo;
    const double hi = 0.5 * format_of(a.hi).pi_hi;
    return wave(Elementary::Sin, a, first, last, lo, hi, -hi, -lo);
}

template <class Real>
Interval<Real> sin(const Interval<Real>& a) {
    return sine_between(a, elementary(Elementary::Sin, -a.neg_lo),
                        elementary(Elementary::Sin, a.hi));
}

template <class Real>
Interval<Real> cos(const Interval<Real>& a) {
    return wave(Elementary::Cos, a, elementary(Elementary::Cos, -a.neg_lo),
                elementary(Elementary::Cos, a.hi), 0.0, 0.0, format_of(a.hi).pi_lo,
                format_of(a.hi).pi_hi);
}

/// Where `a` surely meets no pole of tan or cot; the poles are at phase + pi k.
template <class Real>
auto between_poles(const Interval<Real>& a, double phase_lo, double phase_hi) {
    return both(near_zero(a), no(meets_phase(a, 2, phase_lo, phase_hi)));
}

/// Enclosure of tan or cot: `ends`, from the values at the ends of `a`, where it is smooth. Across
/// a single pole it has no value between the members of `gap`.
template <class Mask, class Real>
Enclosure<Real> branched(const Interval<Real>& a, const Mask& smooth, const Interval<Real>& ends,
                         const Interval<Real>& gap) {
    constexpr double below_pi = 3.0;
    const auto narrow = both(near_zero(a), a.neg_lo + a.hi < like(a.hi, below_pi));
    const Interval<Real> whole = whole_line(a.hi);
    return {.range = select(smooth, ends, whole),
            .everywhere = smooth,
            .gap = select(narrow, gap, whole)};
}

template <class Real>
Enclosure<Real> tan(const Interval<Real>& a) {
    const Format& format = format_of(a.hi);
    const auto smooth = between_poles(a, 0.5 * format.pi_lo, 0.5 * format.pi_hi);
    const Interval<Real> ends = odd_increasing(Elementary::Tan, a);
    return branched(a, smooth, ends, ends);
}

/// Upper bound of 1 / t for the library result t of tan; `at_zero` where the true t may be 0.
template <class Real>
Real cot_up(const Real& t, const Real& at_zero) {
    const Real zero = like(t, 0.0);
    const Real error = library_error(Elementary::Tan, t);
    const Real neg_lo = error - t;
    const auto may_be_zero = both(neg_lo >= zero, t + error >= zero);
    return select(may_be_zero, at_zero, like(t, -1.0) / neg_lo);
}

/// An upper bound as of cot_up, for the values beyond the pole at 0: below 0 where the true t may
/// be 0.
template <class Real>
Real cot_up_behind_pole(const Real& t) {
    const Real largest = magnitude(t) + library_error(Elementary::Tan, t);
    return cot_up(t, like(t, -1.0) / largest);
}

template <class Real>
Enclosure<Real> cot(const Interval<Real>& a) {
    const auto smooth = between_poles(a, 0.0, 0.0);
    const Real neg_t_hi = -elementary(Elementary::Tan, a.hi);
    const Real t_lo = elementary(Elementary::Tan, -a.neg_lo);
    const Real infinite = like(a.hi, infinity);
    const Interval<Real> falling{cot_up(neg_t_hi, infinite), cot_up(t_lo, infinite)};
    const Interval<Real> gap{cot_up_behind_pole(neg_t_hi), cot_up_behind_pole(t_lo)};
    return branched(a, smooth, falling, gap);
}

/// Range of the angle of (x, y), from the corners where it is extreme, for a box in the right half
/// plane or one that does not meet the x axis. For a box across the cut, the negative x axis: from
/// the least angle above the cut to the largest one below it.
template <class Real>
Interval<Real> angle_from_corners(const Interval<Real>& y, const Interval<Real>& x) {
    const Real zero = like(x.hi, 0.0);
    const Real x_lo = -x.neg_lo;
    // At the cut a zero end of y counts to the side beyond the box, whatever its sign.
    const Real y_lo = -(y.neg_lo + zero);
    const Real y_hi = y.hi + zero;
    // Above the x axis the angle falls with x, below it rises; it rises with y where x > 0.
    const auto left = x.hi < zero;
    const Real x_at_max = select(either(y_hi <= zero, both(left, y_lo < zero)), x.hi, x_lo);
    const Real y_at_max = select(x_at_max > zero, y_hi, y_lo);
    const Real x_at_min = select(either(y_lo >= zero, both(left, y_hi >= zero)), x.hi, x_lo);
    const Real y_at_min = select(x_at_min > zero, y_lo, y_hi);
    return widened(Elementary::Atan2, elementary(Elementary::Atan2, y_at_min, x_at_min),
                   elementary(Elementary::Atan2, y_at_max, x_at_max));
}

/// The cases of a box that atan2 distinguishes.
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

/// Outcomes (steps.hpp) for the sides of atan2's cut that a box meets: 0 below the negative x axis,
/// 1 on it and above. A box that does not meet the cut, or that meets the origin, has the outcome
/// 0.
template <class Real>
Interval<Real> angle_sides(const Interval<Real>& y, const Interval<Real>& x) {
    const Real zero = like(x.hi, 0.0);
    return {zero, select(angle_cases(y, x).across_cut, like(zero, 1.0), zero)};
}

/// Enclosure of atan2(y, x) on the given sides of the cut. Where the box has both sides, it is the
/// whole circle and not continuous.
template <class Real>
Enclosure<Real> atan2(const Interval<Real>& y, const Interval<Real>& x,
                      const Interval<Real>& sides) {
    const auto cases = angle_cases(y, x);
    const Real zero = like(x.hi, 0.0);
    // Across the cut, tell whether the box is on one side only.
    const auto above = both(cases.across_cut, sides.neg_lo < zero);
    const auto below = both(cases.across_cut, sides.hi <= zero);
    const auto cut = either(cases.around_origin, both(cases.across_cut, no(either(above, below))));
    const double pi_hi = format_of(x.hi).pi_hi;
    const Interval<Real> circle{like(x.hi, pi_hi), like(x.hi, pi_hi)};
    const Interval<Real> corners = angle_from_corners(y, x);
    // Take the whole circle on both sides, and from the corners to the cut on one.
    const Interval<Real> value{select(either(cut, below), circle.neg_lo, corners.neg_lo),
                               select(either(cut, above), circle.hi, corners.hi)};
    const auto jumps = both(cut, cases.across_cut);
    const Interval<Real> gap = select(jumps, corners, whole_line(x.hi));
    return {.range = clamped(value, -pi_hi, pi_hi),
            .everywhere = no(cases.around_origin),
            .continuous = no(cut),
            .gap = gap};
}

/// Enclosure of atan2(y, x) up to a multiple of 2 pi: continuous across the cut, beyond which it
/// exceeds pi.
template <class Real>
Enclosure<Real> angle(const Interval<Real>& y, const Interval<Real>& x) {
    const auto cases = angle_cases(y, x);
    const auto cut = cases.across_cut;
    const Interval<Real> turned = angle_from_corners(select(cut, -y, y), select(cut, -x, x));
    const Real zero = like(x.hi, 0.0);
    const Format& format = format_of(zero);
    const Interval<Real> half_turn{select(cut, like(zero, -format.pi_lo), zero),
                                   select(cut, like(zero, format.pi_hi), zero)};
    const Interval<Real> circle{like(zero, format.pi_hi), like(zero, format.pi_hi)};
    const Interval<Real> value = select(cases.around_origin, circle, turned + half_turn);
    const auto beside_origin = no(cases.around_origin);
    return {value, {}, beside_origin, beside_origin};
}

}  // namespace zeroset
