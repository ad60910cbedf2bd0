#pragma once

#include "engine/num/enclosure.hpp"

// Functions that jump, and conditions, over any carrier, in upward rounding. Each has one of its
// outcomes between its jumps, a whole number; what is known of it is the interval of the outcomes.
// Those of a condition are 1 where it surely holds, 0 where it surely fails, 0 to 1 elsewhere.

namespace zeroset {

/// A condition with these outcomes: continuous where there is one.
template <class Real>
Enclosure<Real> stepped(const Interval<Real>& outcomes) {
    return {outcomes, {}, {}, outcomes.neg_lo == -outcomes.hi};
}

/// A number with these outcomes: it takes no value between two neighbours.
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

/// An upper bound of the sign: 1 where `a` is NaN.
template <class Real>
Real sign_up(const Real& a) {
    const Real zero = like(a, 0.0);
    return select(a < zero, like(a, -1.0), select(a <= zero, zero, like(a, 1.0)));
}

/// floor(a + 1/2), exact in any rounding mode: a - floor(a) is exact for a > 0 and where it is at
/// most 1/2, and rounding never takes it across 1/2.
template <class Real>
Real nearest_integer(const Real& a) {
    const Real below = round_down(a);
    const auto up = a - below >= like(a, 0.5);
    return select(up, below + like(a, 1.0), below);
}

/// The outcomes of sign, floor, ceil and round.
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

/// a - b floor(a/b) for the floors in `steps`: from 0 to b, and a - b k where the floor is the same
/// k on the whole box. If it is k or k - 1, the values are those of a - b k or of a - b (k - 1).
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

/// A condition that holds for sure, or fails for sure.
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

/// A mask of the whole from that of one side, which says nothing where that side is never taken.
template <class Mask>
std::optional<Mask> where_taken(const Mask& taken, const std::optional<Mask>& mask) {
    if (!mask) return mask;
    return either(no(taken), *mask);
}

/// a where the condition c holds, b elsewhere. The hull of both where c is undecided, but for a
/// side that is nowhere defined.
template <class Real>
Enclosure<Real> choose(const Enclosure<Real>& c, const Enclosure<Real>& a,
                       const Enclosure<Real>& b) {
    const auto holds = may_hold(c.range);
    const auto fails = may_fail(c.range);
    const auto use_a = a.somewhere ? both(holds, *a.somewhere) : holds;
    const auto use_b = b.somewhere ? both(fails, *b.somewhere) : fails;
    const Interval<Real> hull{larger_bound(a.range.neg_lo, b.range.neg_lo),
                              larger_bound(a.range.hi, b.range.hi)};
    Enclosure<Real> result{select(use_a, select(use_b, hull, a.range), b.range)};
    const Interval<Real> a_first{b.range.neg_lo, a.range.hi};
    const Interval<Real> b_first{a.range.neg_lo, b.range.hi};
    const Interval<Real> anything = whole_line(a.range.hi);
    const Interval<Real> taken = select(use_a, a.gap.value_or(anything), b.gap.value_or(anything));
    result.gap =
        select(both(use_a, use_b), select(a.range.hi < -b.range.neg_lo, a_first, b_first), taken);
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

/// a where the condition c holds, undefined elsewhere.
template <class Real>
Enclosure<Real> where(const Enclosure<Real>& a, const Enclosure<Real>& c) {
    Enclosure<Real> result = a;
    result.somewhere = conjunction(conjunction(a.somewhere, c.somewhere), {may_hold(c.range)});
    result.everywhere =
        conjunction(conjunction(a.everywhere, c.everywhere), {no(may_fail(c.range))});
    return result;
}

/// a times the sign of b, without what is known of the operands' domains. Beside a zero of b the
/// values are on both sides of 0, as far from it as those of a.
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
    const Real neg_least = minimum(a.range.neg_lo, a.range.hi);  // where a has no zero
    const auto says_nothing = either(known, unordered(a.range.neg_lo, a.range.hi));
    const Real size = select(says_nothing, like(zero, infinity), neg_least);
    std::optional<Interval<Real>> gap{Interval<Real>{size, size}};
    if (a.gap) gap = sharper(gap, std::optional(turned(*a.gap)));
    return {.range = turned(a.range), .everywhere = known, .gap = gap};
}

}  // namespace zeroset
