#pragma once

#include "engine/num/enclosure.hpp"

// Functions that jump, and conditions, over any carrier, in upward rounding. Between its jumps each
// has a single outcome, an integer; what is known of it is an interval of outcomes. The outcomes of
// a condition are 1 where it surely holds, 0 where it surely fails, 0 to 1 elsewhere.

namespace zeroset {

/// Enclosure of a condition with these outcomes; continuous where there is a single one.
template <class Real>
Enclosure<Real> stepped(const Interval<Real>& outcomes) {
    return {outcomes, {}, {}, outcomes.neg_lo == -outcomes.hi};
}

/// Enclosure of a number with these outcomes: it takes no value between two neighbouring ones.
template <class Real>
Enclosure<Real> jumping(const Interval<Real>& outcomes) {
    Enclosure<Real> result = stepped(outcomes);
    const Interval<Real> between{-outcomes.hi, -outcomes.neg_lo};
    const auto neighbours = outcomes.neg_lo + outcomes.hi <= like(outcomes.hi, 1.0);
    result.gap = select(neighbours, between, whole_line(outcomes.hi));
    return result;
}

template <class Real>
Real sign_of(const Real& a) {
    const Real zero = like(a, 0.0);
    return select(a > zero, like(a, 1.0), select(a < zero, like(a, -1.0), zero));
}

/// Upper bound of the sign of `a`; 1 where `a` is NaN.
template <class Real>
Real sign_up(const Real& a) {
    const Real zero = like(a, 0.0);
    return select(a < zero, like(a, -1.0), select(a <= zero, zero, like(a, 1.0)));
}

/// floor(a + 1/2), exact in any rounding mode: a - floor(a) is exact for a > 0 and where it is at
/// most 1/2, and otherwise rounding never takes it across 1/2.
template <class Real>
Real nearest_integer(const Real& a) {
    const Real below = round_down(a);
    const auto up = a - below >= like(a, 0.5);
    return select(up, below + like(a, 1.0), below);
}

/// Outcomes of sign, floor, ceil and round over an interval.
template <class Real>
Interval<Real> sign_steps(const Interval<Real>& a) {
    return {sign_up(a.neg_lo), sign_up(a.hi)};
}
template <class Real>
Interval<Real> floor_steps(const Interval<Real>& a) {
    return {-round_down(-a.neg_lo), round_down(a.hi)};
}
template <class Real>
Interval<Real> ceil_steps(const Interval<Real>& a) {
    return {round_down(a.neg_lo), -round_down(-a.hi)};
}
template <class Real>
Interval<Real> round_steps(const Interval<Real>& a) {
    return {-nearest_integer(-a.neg_lo), nearest_integer(a.hi)};
}

/// a - b floor(a/b), where `steps` holds the possible floors. The values are between 0 and b, and
/// equal to a - b k where the floor is a single k. Where it is k or k - 1, every value belongs
/// to a - b k or to a - b (k - 1), which `gap` separates.
template <class Real>
Enclosure<Real> mod(const Interval<Real>& a, const Interval<Real>& b, const Interval<Real>& steps) {
    const Real zero = like(a.hi, 0.0);
    const Real& k = steps.hi;
    const Real first_k = -steps.neg_lo;
    const auto one_step = k == first_k;
    const Interval<Real> from_zero{maximum(zero, b.neg_lo), maximum(zero, b.hi)};
    const Interval<Real> shifted = a - b * point(k);
    const Interval<Real> tight{minimum(shifted.neg_lo, from_zero.neg_lo),
                               minimum(shifted.hi, from_zero.hi)};
    const Interval<Real> before = a - b * point(first_k);
    const auto one_jump = both(k - first_k <= like(k, 1.0), excludes_zero(b));
    const Interval<Real> gap =
        select(one_jump, Interval<Real>{before.neg_lo, shifted.hi}, whole_line(zero));
    return {.range = select(one_step, tight, from_zero),
            .everywhere = excludes_zero(b),
            .continuous = one_step,
            .gap = gap};
}

/// Outcomes of a condition, given where it surely holds and where it surely fails.
template <class Real>
Interval<Real> condition(const auto& holds, const auto& fails, const Real& kind) {
    const Real zero = like(kind, 0.0);
    return {select(holds, like(kind, -1.0), zero), select(fails, zero, like(kind, 1.0))};
}

template <class Real>
Interval<Real> less(const Interval<Real>& a, const Interval<Real>& b) {
    return condition(a.hi < -b.neg_lo, -a.neg_lo >= b.hi, a.hi);
}
template <class Real>
Interval<Real> less_equal(const Interval<Real>& a, const Interval<Real>& b) {
    return condition(a.hi <= -b.neg_lo, -a.neg_lo > b.hi, a.hi);
}

template <class Real>
auto may_hold(const Interval<Real>& condition) {
    return condition.hi > like(condition.hi, 0.0);
}
template <class Real>
auto may_fail(const Interval<Real>& condition) {
    return condition.neg_lo >= like(condition.hi, 0.0);
}

/// `mask` of one operand of a choice, made true where that operand is never taken.
template <class Mask>
std::optional<Mask> where_taken(const Mask& taken, const std::optional<Mask>& mask) {
    if (!mask) return mask;
    return either(no(taken), *mask);
}

/// Enclosure of a where the condition c holds, of b elsewhere. Where c is undecided, the hull of
/// both, without an operand that is defined nowhere.
template <class Real>
Enclosure<Real> choose(const Enclosure<Real>& c, const Enclosure<Real>& a,
                       const Enclosure<Real>& b) {
    const auto holds = may_hold(c.range);
    const auto fails = may_fail(c.range);
    // Count an operand where it may be taken and may be defined.
    const auto use_a = a.somewhere ? both(holds, *a.somewhere) : holds;
    const auto use_b = b.somewhere ? both(fails, *b.somewhere) : fails;
    const Interval<Real> hull{larger_bound(a.range.neg_lo, b.range.neg_lo),
                              larger_bound(a.range.hi, b.range.hi)};
    Enclosure<Real> result{select(use_a, select(use_b, hull, a.range), b.range)};
    // Find the gap between the two ranges where both count, else take the one operand's gap.
    const Interval<Real> a_first{b.range.neg_lo, a.range.hi};
    const Interval<Real> b_first{a.range.neg_lo, b.range.hi};
    const Interval<Real> anything = whole_line(a.range.hi);
    const Interval<Real> taken = select(use_a, a.gap.value_or(anything), b.gap.value_or(anything));
    result.gap =
        select(both(use_a, use_b), select(a.range.hi < -b.range.neg_lo, a_first, b_first), taken);
    // Combine the domains; an operand that is never taken does not matter.
    result.somewhere = c.somewhere;
    if (a.somewhere || b.somewhere) {
        result.somewhere = conjunction(c.somewhere, {either(use_a, use_b)});
    }
    result.everywhere = conjunction(c.everywhere, conjunction(where_taken(holds, a.everywhere),
                                                              where_taken(fails, b.everywhere)));
    result.continuous = conjunction(
        {no(both(holds, fails))},
        conjunction(where_taken(holds, a.continuous), where_taken(fails, b.continuous)));
    return result;
}

/// Enclosure of a where the condition c holds; undefined elsewhere.
template <class Real>
Enclosure<Real> where(const Enclosure<Real>& a, const Enclosure<Real>& c) {
    Enclosure<Real> result = a;
    result.somewhere = conjunction(conjunction(a.somewhere, c.somewhere), {may_hold(c.range)});
    result.everywhere =
        conjunction(conjunction(a.everywhere, c.everywhere), {no(may_fail(c.range))});
    return result;
}

/// Enclosure of a where b > 0 and of -a where b < 0; the masks are those of `oriented` alone,
/// without its operands'. Where b may be 0, the values are on both sides of 0, as far from it as
/// those of a.
template <class Real>
Enclosure<Real> oriented(const Enclosure<Real>& a, const Interval<Real>& b) {
    const Real zero = like(b.hi, 0.0);
    const auto above = b.neg_lo < zero;
    const auto below = b.hi < zero;
    const auto turned = [&](const Interval<Real>& v) {
        const Real far = larger_bound(v.neg_lo, v.hi);
        return select(above, v, select(below, -v, Interval<Real>{far, far}));
    };
    const auto known = either(above, below);
    // Minus the least |a|, where a has no zero
    const Real neg_least = minimum(a.range.neg_lo, a.range.hi);
    const auto says_nothing = either(known, unordered(a.range.neg_lo, a.range.hi));
    const Real size = select(says_nothing, like(zero, infinity), neg_least);
    std::optional<Interval<Real>> gap{Interval<Real>{size, size}};
    if (a.gap) gap = sharper(gap, std::optional(turned(*a.gap)));
    return {.range = turned(a.range), .everywhere = known, .gap = gap};
}

}  // namespace zeroset
