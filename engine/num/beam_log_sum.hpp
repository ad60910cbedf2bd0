#pragma once

#include "engine/num/beam_functions.hpp"
#include "engine/num/log_sum.hpp"

// Beam forms of ln(e^a + e^b), over any carrier, in upward rounding. With d = b - a the sum is a +
// g(d) for the convex g(d) = ln(1 + e^d); g'(d) is the share of e^b in e^a + e^b.

namespace zeroset {

/// Enclosures of g' and g'' at a point d.
template <class Real>
struct SoftStep {
    Real ratio;                     ///< e^-|d|
    Interval<Real> share;           ///< g'
    Interval<Real> ratio_of_share;  ///< g''
};

template <class Real>
SoftStep<Real> soft_step(const Real& d) {
    const Real one = like(d, 1.0);
    const Real ratio = elementary(Elementary::Exp, -magnitude(d));
    const Real larger = one / (ratio + one);
    const Real smaller = ratio * larger;
    const auto enclosed = [](const Real& value) {
        const Real error = log_sum_error(value);
        return Interval<Real>{error - value, value + error};
    };
    const Interval<Real> share = enclosed(select(d > like(d, 0.0), larger, smaller));
    const Interval<Real> bend = enclosed(smaller * larger);
    return {ratio, clamped(share, 0.0, 1.0), clamped(bend, 0.0, 0.25)};
}

/// Bounds of g over the range x of its operand, whose middle is `middle`.
template <class Real>
FunctionBounds<Real> soft_step_bounds(const Interval<Real>& x, const Real& middle) {
    const auto number = [&](double value) { return like(middle, value); };
    const Real zero = number(0.0);
    const SoftStep<Real> lo = soft_step(-x.neg_lo);
    const SoftStep<Real> hi = soft_step(x.hi);
    const SoftStep<Real> at = soft_step(middle);
    const Interval<Real> value = log_sum(point(middle), point(zero));
    // ln(1 + t) is in [t - t^2/2, t].
    const Real least = lo.ratio * (number(0.5) * lo.ratio - number(1.0));
    const Real most = minimum(hi.ratio + log_sum_error(hi.ratio), number(0.6931472));
    const Interval<Real> range{
        minimum(x.neg_lo, zero) + minimum(least + log_sum_error(lo.ratio), zero),
        maximum(x.hi, zero) + most};
    const auto around_zero = both(x.neg_lo >= zero, x.hi >= zero);
    const Interval<Real> bend{
        maximum(lo.ratio_of_share.neg_lo, hi.ratio_of_share.neg_lo),
        select(around_zero, number(0.25), maximum(lo.ratio_of_share.hi, hi.ratio_of_share.hi))};
    return {range, {lo.share.neg_lo, hi.share.hi}, bend, value, at.share, 4.0};
}

template <class Real>
struct LogSumBeam {
    Beam<Real> sum;
    Beam<Real> share;  ///< of the operand that is smaller at the middle
};

/// ln(e^a + e^b). `first`: where a is taken for the larger operand; `kink` is that of a - b.
template <class Real, class Mask>
LogSumBeam<Real> log_sum(const Beam<Real>& a, const Beam<Real>& b, const Mask& first,
                         const Kink<Real>& kink) {
    // Add g of the difference to the larger operand.
    const Beam<Real> larger_one = select(first, a, b);
    const Beam<Real> difference = select(first, b, a) - larger_one;
    const FunctionBounds<Real> g = soft_step_bounds(difference.range(), difference.f.c);
    const Beam<Real> rest = curve(difference, g);
    const Affine<Real> smooth = larger_one.f + rest.f;
    // The sum exceeds the larger operand by at most ln 2, and hardly at all where they differ
    // widely.
    const Beam<Real> extreme = larger(a, b, kink, 1.0);
    const Real most = select(either(kink.above, kink.below),
                             minimum(largest(g.range), like(a.r, 0.6931472)), like(a.r, 0.6931472));
    Affine<Real> sharp = extreme.f;
    const Real half = like(a.r, 0.5) * most;
    sharp.c = sharp.c + half;
    sharp.e = sharp.e + half;
    const Real size = larger_bound(a.size, b.size) + like(a.r, 1.0);
    const auto better = smooth.e < sharp.e;  // false where NaN
    // The operands' rounding errors are weighted by their shares, whose sum is 1.
    const Real rounding =
        fused(largest(g.slope), a.size + b.size, fused(like(a.r, 16.0), largest(g.range), size));
    return {{select(better, smooth, sharp),
             larger_bound(a.r, b.r) + select(better, rounding, like(a.r, 5.0) * size), size},
            slope_of_curve(difference, g)};
}

}  // namespace zeroset
