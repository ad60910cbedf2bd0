#pragma once

#include "engine/num/beam.hpp"
#include "engine/num/periodic.hpp"

#include <initializer_list>

// Beam forms of functions, over any carrier, in upward rounding.

namespace zeroset {

template <class Real>
Real largest(const Interval<Real>& a) {
    return maximum(a.neg_lo, a.hi);
}

/// The form `b` where the mask holds, else the interval.
template <class Mask, class Real>
Affine<Real> form_or_interval(const Mask& use_form, const Affine<Real>& form,
                              const Interval<Real>& otherwise) {
    const Affine<Real> box = centred(otherwise);
    const Real zero = like(box.c, 0.0);
    Affine<Real> result{select(use_form, form.c, box.c), {}, select(use_form, form.e, box.e)};
    for (std::size_t i = 0; i < 3; ++i) {
        if (form.k[i]) result.k[i] = select(use_form, *form.k[i], zero);
    }
    return result;
}

/// alpha a + shift + [-e, e], without its rounding.
template <class Real>
Affine<Real> linear_map(const Affine<Real>& a, const Real& alpha, const Real& shift,
                        const Real& e) {
    Affine<Real> result = scaled(a, alpha);
    result.c = result.c + shift;
    result.e = result.e + e;
    return result;
}

/// A function g of one variable, as it is known over the range of its operand x, and at its middle
/// c.
template <class Real>
struct FunctionBounds {
    Interval<Real> range;      ///< of g
    Interval<Real> slope;      ///< of g'
    Interval<Real> curvature;  ///< of g''
    Interval<Real> at_middle;  ///< g(c)
    Interval<Real> slope_at_middle;
    double rounding_ulp;  ///< of an evaluation at a point
};

/// The r of g, of slopes in `slope`: that of the operand by the greatest slope, and its own.
template <class Real>
Real rounding_of(const Interval<Real>& slope, const Real& operand_r, double ulp, const Real& size) {
    return largest(slope) * operand_r + like(size, ulp) * size;
}

/// A line through a function's value at the middle c of its operand x.
template <class Real>
struct Line {
    Interval<Real> at_middle;
    Real slope;
    Interval<Real> rest;  ///< what the function is more than the line
};

/// The function's form from a line, or from its range where that is narrower, with the r of either.
/// Makes no more than four roundings of numbers below twice the range's.
template <class Real>
Beam<Real> along_line(const Beam<Real>& x, const Line<Real>& line, const Interval<Real>& range,
                      const Real& r_of_line, const Real& r_of_range) {
    const Affine<Real> middle = centred(line.at_middle + line.rest);
    Affine<Real> moved = x.f;
    moved.c = like(x.r, 0.0);
    const Affine<Real> form = linear_map(moved, line.slope, middle.c, middle.e);
    const Real width = range.neg_lo + range.hi;
    const auto better = form.e + form.e < width;  // false where NaN
    return {form_or_interval(better, form, range), select(better, r_of_line, r_of_range),
            largest(range)};
}

/// [-size, size]
template <class Real>
Interval<Real> within(const Real& size) {
    return {size, size};
}

/// g by Taylor's theorem: g(c + d) - g(c) - g'(c) d is g'' d^2 / 2 at some place between.
template <class Real>
Beam<Real> curve(const Beam<Real>& x, const FunctionBounds<Real>& g) {
    const Real zero = like(x.r, 0.0);
    const Real& d = x.spread();
    const Real half_square = like(d, 0.5) * d * d;
    const Affine<Real> slope = centred(g.slope_at_middle);
    const Interval<Real> bend{maximum(zero, g.curvature.neg_lo) * half_square,  // NaN stays
                              maximum(zero, g.curvature.hi) * half_square};
    const Line<Real> line{g.at_middle, slope.c, bend + within<Real>(slope.e * d)};
    const Real r = rounding_of(g.slope, x.r, g.rounding_ulp, largest(g.range));
    return along_line(x, line, g.range, r, r);
}

/// g' by the mean value theorem: g'' less its middle bounds the error. No value kernel computes it,
/// so that its range has no r.
template <class Real>
Beam<Real> slope_of_curve(const Beam<Real>& x, const FunctionBounds<Real>& g) {
    const Affine<Real> bend = centred(g.curvature);
    const Line<Real> line{g.slope_at_middle, bend.c, within<Real>(bend.e * x.spread())};
    const Real r = rounding_of(g.curvature, x.r, 4.0, largest(g.slope));
    return along_line(x, line, g.slope, r, like(r, 0.0));
}

/// Also bounded by [-1, 1].
template <class Real>
Interval<Real> within_one(const Interval<Real>& a) {
    return clamped(a, -1.0, 1.0);
}

/// g and g' at the middle.
template <class Real>
struct WaveAtMiddle {
    Interval<Real> value, slope;
};

template <class Real>
WaveAtMiddle<Real> sin_at(const Real& c) {
    const Real sine = elementary(Elementary::Sin, c);
    const Real cosine = elementary(Elementary::Cos, c);
    return {within_one(widened(Elementary::Sin, sine, sine)),
            within_one(widened(Elementary::Cos, cosine, cosine))};
}
template <class Real>
WaveAtMiddle<Real> cos_at(const Real& c) {
    const WaveAtMiddle<Real> sine = sin_at(c);
    return {sine.slope, -sine.value};
}

/// [a - d, a + d] within [-1, 1].
template <class Real>
Interval<Real> wave_near(const Interval<Real>& a, const Real& d) {
    return within_one(without_nan(Interval<Real>{a.neg_lo + d, a.hi + d}));
}

/// What a sine or cosine does over the range of x: g'' is -g, so both bound each other.
template <class Real>
FunctionBounds<Real> wave_over(const Beam<Real>& x, const WaveAtMiddle<Real>& middle) {
    const Real one = like(x.r, 1.0);
    const Real d = x.spread();
    const Real steepest = minimum(largest(middle.slope) + d, one);
    const Real highest = minimum(largest(middle.value) + d, one);
    const Interval<Real> range = wave_near(middle.value, d * steepest);
    const Interval<Real> slope = wave_near(middle.slope, d * highest);
    return {range, slope, -range, middle.value, middle.slope, 4.0};
}

/// sqrt(x) less alpha x, on x >= 0, is at most 1 / (4 alpha) for any alpha > 0, and least at an
/// end of the range.
template <class Real>
Beam<Real> sqrt(const Beam<Real>& x, const FunctionBounds<Real>& g, const Interval<Real>& range) {
    const auto number = [&](double value) { return like(x.r, value); };
    const Real alpha = number(1) / (g.range.hi - g.range.neg_lo);
    const Real most = number(0.25) / alpha;
    // g.range.hi is a root rounded upward.
    const Real below = g.range.hi * number(-(1.0 - format_of(alpha).relative_gap));
    const Real neg_least =
        maximum(alpha * -range.neg_lo + g.range.neg_lo, alpha * range.hi + below);
    const Affine<Real> rest = centred(Interval<Real>{neg_least, most});
    const auto inside = range.neg_lo < number(0);
    const Real size = g.range.hi;
    return {form_or_interval(inside, linear_map(x.f, alpha, rest.c, rest.e), g.range),
            rounding_of(g.slope, x.r, g.rounding_ulp, size), size};
}

/// 1/y, where the range `box` of y does not hold 0; nothing is known elsewhere. For p = |y| on [l,
/// h] and any beta, 1/p + beta p is greatest at an end and at least 2 sqrt(beta). Beta 1/(l h)
/// makes the narrowest form, 1/h^2 one with the range of 1/p: better where h is several times l, as
/// no false zero comes in beside the pole.
template <class Real>
Beam<Real> reciprocal(const Beam<Real>& y, const Interval<Real>& box) {
    const auto number = [&](double value) { return like(y.r, value); };
    const auto negative = box.hi < number(0);
    const auto nonzero = either(negative, box.neg_lo < number(0));
    const Real low = select(negative, -box.hi, -box.neg_lo);
    const Real high = select(negative, box.neg_lo, box.hi);
    const Real one = number(1);
    const Real per_low = one / low;
    const Real per_high = one / high;
    const auto wide = high > number(3) * low;
    const Real beta = select(wide, per_high, per_low) * per_high;
    const Real most = larger_bound(per_low + beta * low, per_high + beta * high);
    const Real least = number(2.0 - 4 * format_of(beta).relative_gap) * square_root(beta);
    const Affine<Real> rest = centred(Interval<Real>{-least, most});
    const Affine<Real> form = linear_map(y.f, -beta, select(negative, -rest.c, rest.c), rest.e);
    const Interval<Real> unknown = whole_line(one);
    const Real size = select(nonzero, per_low, number(infinity));
    return {form_or_interval(nonzero, form, unknown), size * (size * y.r + one), size};
}

/// |d| for d in [lo, hi] is in alpha d + [0, rest] for any alpha from -1 to 1.
template <class Real>
struct Kink {
    using Mask = typename Enclosure<Real>::Mask;

    Mask above, below;  ///< d is nowhere below 0, nowhere above 0
    Real alpha;
    Real rest;
};

template <class Real>
Kink<Real> kink_of(const Interval<Real>& d) {
    const Real one = like(d.hi, 1.0);
    const Real zero = like(d.hi, 0.0);
    const auto above = d.neg_lo <= zero;
    const auto below = d.hi <= zero;
    // 1 where NaN.
    const Real secant = maximum(minimum((d.hi - d.neg_lo) / (d.hi + d.neg_lo), one), -one);
    const Real alpha = select(above, one, select(below, -one, secant));
    const Real rest = maximum(maximum(d.hi * (one - alpha), d.neg_lo * (one + alpha)), zero);
    return {above, below, alpha, rest};
}

template <class Real>
Beam<Real> abs(const Beam<Real>& a, const Kink<Real>& kink) {
    const Real half = kink.rest * like(a.r, 0.5);
    return {linear_map(a.f, kink.alpha, half, half), a.r + a.size, a.size};
}

/// max(a, b) = (a + b + |a - b|) / 2; `kink` is that of a - b. The smaller for `sign` -1.
template <class Real>
Beam<Real> larger(const Beam<Real>& a, const Beam<Real>& b, const Kink<Real>& kink, double sign) {
    const Real half = like(a.r, 0.5);
    const Real lean = kink.alpha * like(a.r, 0.5 * sign);
    const Real quarter = kink.rest * like(a.r, 0.25);
    Affine<Real> f = scaled(a.f, half + lean) + scaled(b.f, half - lean);
    f.c = f.c + quarter * like(a.r, sign);
    f.e = f.e + quarter;
    const Real size = larger_bound(a.size, b.size);
    // Where one of the forms is taken as it is, nothing is rounded.
    const Real rounding =
        select(either(kink.above, kink.below), like(a.r, 0.0), like(a.r, 4.0) * size);
    return {f, larger_bound(a.r, b.r) + rounding, size};
}

/// Between two forms: w a + (1 - w) b, whatever w in [0, 1].
template <class Real>
SlopeBeam<Real> hull(const SlopeBeam<Real>& a, const SlopeBeam<Real>& b) {
    SlopeBeam<Real> result = scale(a + b, 0.5);
    result.f.e = result.f.e + like(a.size, 0.5) * largest(a.f - b.f);
    result.size = larger_bound(a.size, b.size);
    return result;
}

template <class Mask, class Real>
Affine<Real> select(const Mask& condition, const Affine<Real>& a, const Affine<Real>& b) {
    Affine<Real> f{select(condition, a.c, b.c), {}, select(condition, a.e, b.e)};
    const Real zero = like(a.c, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!a.k[i] && !b.k[i]) continue;
        f.k[i] = select(condition, a.k[i].value_or(zero), b.k[i].value_or(zero));
    }
    return f;
}
template <class Mask, class Real>
Beam<Real> select(const Mask& condition, const Beam<Real>& a, const Beam<Real>& b) {
    return {select(condition, a.f, b.f), select(condition, a.r, b.r),
            select(condition, a.size, b.size)};
}
template <class Mask, class Real>
SlopeBeam<Real> select(const Mask& condition, const SlopeBeam<Real>& a, const SlopeBeam<Real>& b) {
    return {select(condition, a.f, b.f), select(condition, a.size, b.size)};
}

/// Between the ends of an interval. `r`: of what it encloses.
template <class Real>
Beam<Real> interval_form(const Interval<Real>& a, const Real& r) {
    return {centred(a), r, largest(a)};
}

/// A factor of a derivative: its rounding is that of its middle.
template <class Real>
Beam<Real> factor(const Interval<Real>& a) {
    return interval_form(a, largest(a));
}

}  // namespace zeroset
