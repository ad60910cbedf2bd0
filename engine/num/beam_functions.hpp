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

/// `form` where the mask holds, else the interval as a form.
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

/// alpha a + shift + [-e, e], without the rounding errors of the coefficients.
template <class Real>
Affine<Real> linear_map(const Affine<Real>& a, const Real& alpha, const Real& shift,
                        const Real& e) {
    Affine<Real> result = scaled(a, alpha);
    result.c = result.c + shift;
    result.e = result.e + e;
    return result;
}

/// Bounds of a function g of one variable, over the range of its operand x and at its middle c.
template <class Real>
struct FunctionBounds {
    Interval<Real> range;            ///< encloses g(x)
    Interval<Real> slope;            ///< encloses g'(x)
    Interval<Real> curvature;        ///< encloses g''(x)
    Interval<Real> at_middle;        ///< encloses g(c)
    Interval<Real> slope_at_middle;  ///< encloses g'(c)
    double rounding_ulp;             ///< error of evaluating g at a point
};

/// r of g(x): the operand's r times the greatest |g'|, plus g's own error, `ulp` units of `size`.
template <class Real>
Real rounding_of(const Interval<Real>& slope, const Real& operand_r, double ulp, const Real& size) {
    return largest(slope) * operand_r + like(size, ulp) * size;
}

/// A line through a function's value at the middle c of its operand x, of slope `slope`.
template <class Real>
struct MiddleLine {
    Interval<Real> at_middle;
    Real slope;
    Interval<Real> rest;  ///< encloses the function minus the line
};

/// Form of a function from its line, or from its range where that is narrower, with the r of the
/// one taken. Makes at most four roundings, of numbers below twice the bounds of the range.
template <class Real>
Beam<Real> along_line(const Beam<Real>& x, const MiddleLine<Real>& line,
                      const Interval<Real>& range, const Real& r_of_line, const Real& r_of_range) {
    const Affine<Real> middle = centred(line.at_middle + line.rest);
    Affine<Real> moved = x.f;
    moved.c = like(x.r, 0.0);
    const Affine<Real> form = linear_map(moved, line.slope, middle.c, middle.e);
    const Real width = range.neg_lo + range.hi;
    const auto better = form.e + form.e < width;  // false where NaN
    return {form_or_interval(better, form, range), select(better, r_of_line, r_of_range),
            largest(range)};
}

/// The interval [-size, size].
template <class Real>
Interval<Real> within(const Real& size) {
    return {size, size};
}

/// Form of g(x) by Taylor's theorem: g(c + d) - g(c) - g'(c) d = g''(s) d^2 / 2 for some s between
/// c and c + d.
template <class Real>
Beam<Real> curve(const Beam<Real>& x, const FunctionBounds<Real>& g) {
    const Real zero = like(x.r, 0.0);
    const Real& d = x.spread();
    const Real half_square = like(d, 0.5) * d * d;
    const Affine<Real> slope = centred(g.slope_at_middle);
    const Interval<Real> bend{maximum(zero, g.curvature.neg_lo) * half_square,  // keeps NaN
                              maximum(zero, g.curvature.hi) * half_square};
    const MiddleLine<Real> line{g.at_middle, slope.c, bend + within<Real>(slope.e * d)};
    const Real r = rounding_of(g.slope, x.r, g.rounding_ulp, largest(g.range));
    return along_line(x, line, g.range, r, r);
}

/// Form of g'(x) by the mean value theorem: the slope is the middle of g'', and the rest of g''
/// bounds the error. Its range has r = 0, as no value kernel computes g'.
template <class Real>
Beam<Real> slope_of_curve(const Beam<Real>& x, const FunctionBounds<Real>& g) {
    const Affine<Real> bend = centred(g.curvature);
    const MiddleLine<Real> line{g.slope_at_middle, bend.c, within<Real>(bend.e * x.spread())};
    const Real r = rounding_of(g.curvature, x.r, 4.0, largest(g.slope));
    return along_line(x, line, g.slope, r, like(r, 0.0));
}

/// The part of the interval in [-1, 1].
template <class Real>
Interval<Real> within_one(const Interval<Real>& a) {
    return clamped(a, -1.0, 1.0);
}

/// Enclosures of a wave g and of g' at the middle of its operand.
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

/// [a - d, a + d], cut to [-1, 1].
template <class Real>
Interval<Real> wave_near(const Interval<Real>& a, const Real& d) {
    return within_one(without_nan(Interval<Real>{a.neg_lo + d, a.hi + d}));
}

/// Bounds of a sine or cosine g over the range of x: as g'' = -g, g and g' bound each other's
/// change.
template <class Real>
FunctionBounds<Real> wave_over(const Beam<Real>& x, const WaveAtMiddle<Real>& middle) {
    const Real one = like(x.r, 1.0);
    const Real d = x.spread();
    const Real steepest = minimum(largest(middle.slope) + d, one);
    const Real highest = minimum(largest(middle.value) + d, one);
    const Interval<Real> range = wave_near(middle.value, d * steepest);
    const Interval<Real> slope = wave_near(middle.slope, d * highest);
    return {.range = range,
            .slope = slope,
            .curvature = -range,
            .at_middle = middle.value,
            .slope_at_middle = middle.slope,
            .rounding_ulp = 4.0};
}

/// Form of sqrt(x): on x >= 0, sqrt(x) - alpha x is at most 1 / (4 alpha) for any alpha > 0, and
/// least at an end of the range. Where `range` of x is not above 0, the form is the interval
/// g.range.
template <class Real>
Beam<Real> sqrt(const Beam<Real>& x, const FunctionBounds<Real>& g, const Interval<Real>& range) {
    const auto number = [&](double value) { return like(x.r, value); };
    const Real alpha = number(1) / (g.range.hi - g.range.neg_lo);
    const Real most = number(0.25) / alpha;
    // g.range.hi is a root rounded upward; -below is a lower bound of that root.
    const Real below = g.range.hi * number(-(1.0 - format_of(alpha).relative_gap));
    const Real neg_least =
        maximum(alpha * -range.neg_lo + g.range.neg_lo, alpha * range.hi + below);
    const Affine<Real> rest = centred(Interval<Real>{neg_least, most});
    const auto inside = range.neg_lo < number(0);
    const Real size = g.range.hi;
    return {form_or_interval(inside, linear_map(x.f, alpha, rest.c, rest.e), g.range),
            rounding_of(g.slope, x.r, g.rounding_ulp, size), size};
}

/// Form of 1/y where the range `box` of y excludes 0; elsewhere nothing is known. For p = |y| in
/// [l, h] and any beta > 0, 1/p + beta p is greatest at an end and at least 2 sqrt(beta). beta =
/// 1/(l h) makes the narrowest form; beta = 1/h^2 makes one with the range of 1/p, better where h
/// is several times l, as it brings no false zero beside the pole.
template <class Real>
Beam<Real> reciprocal(const Beam<Real>& y, const Interval<Real>& box) {
    const auto number = [&](double value) { return like(y.r, value); };
    const auto negative = box.hi < number(0);
    const auto nonzero = either(negative, box.neg_lo < number(0));
    // Bound p by [low, high].
    const Real low = select(negative, -box.hi, -box.neg_lo);
    const Real high = select(negative, box.neg_lo, box.hi);
    const Real one = number(1);
    const Real per_low = one / low;
    const Real per_high = one / high;
    const auto wide = high > number(3) * low;
    const Real beta = select(wide, per_high, per_low) * per_high;
    // Bound 1/p + beta p.
    const Real most = larger_bound(per_low + beta * low, per_high + beta * high);
    const Real least = number(2.0 - 4 * format_of(beta).relative_gap) * square_root(beta);
    const Affine<Real> rest = centred(Interval<Real>{-least, most});
    const Affine<Real> form = linear_map(y.f, -beta, select(negative, -rest.c, rest.c), rest.e);
    const Interval<Real> unknown = whole_line(one);
    const Real size = select(nonzero, per_low, number(infinity));
    return {form_or_interval(nonzero, form, unknown), size * (size * y.r + one), size};
}

/// Linear enclosure of |d| for d in [lo, hi]: alpha d + [0, rest], with alpha in [-1, 1].
template <class Real>
struct Kink {
    using Mask = typename Enclosure<Real>::Mask;

    Mask above, below;  ///< d >= 0, or d <= 0, in the whole range
    Real alpha;
    Real rest;
};

template <class Real>
Kink<Real> kink_of(const Interval<Real>& d) {
    const Real one = like(d.hi, 1.0);
    const Real zero = like(d.hi, 0.0);
    const auto above = d.neg_lo <= zero;
    const auto below = d.hi <= zero;
    // The slope of the secant, 1 where NaN.
    const Real secant = maximum(minimum((d.hi - d.neg_lo) / (d.hi + d.neg_lo), one), -one);
    const Real alpha = select(above, one, select(below, -one, secant));
    const Real rest = maximum(maximum(d.hi * (one - alpha), d.neg_lo * (one + alpha)), zero);
    return {.above = above, .below = below, .alpha = alpha, .rest = rest};
}

template <class Real>
Beam<Real> abs(const Beam<Real>& a, const Kink<Real>& kink) {
    const Real half = kink.rest * like(a.r, 0.5);
    return {linear_map(a.f, kink.alpha, half, half), a.r + a.size, a.size};
}

/// max(a, b) = (a + b + |a - b|) / 2, or min(a, b) for `sign` -1; `kink` is that of a - b.
template <class Real>
Beam<Real> larger(const Beam<Real>& a, const Beam<Real>& b, const Kink<Real>& kink, double sign) {
    const Real half = like(a.r, 0.5);
    const Real lean = kink.alpha * like(a.r, 0.5 * sign);
    const Real quarter = kink.rest * like(a.r, 0.25);
    Affine<Real> f = scaled(a.f, half + lean) + scaled(b.f, half - lean);
    f.c = f.c + quarter * like(a.r, sign);
    f.e = f.e + quarter;
    const Real size = larger_bound(a.size, b.size);
    // Where a - b keeps its sign, the result is an operand as it is and nothing is rounded.
    const Real rounding =
        select(either(kink.above, kink.below), like(a.r, 0.0), like(a.r, 4.0) * size);
    return {f, larger_bound(a.r, b.r) + rounding, size};
}

/// Form that encloses w a + (1 - w) b for every w in [0, 1].
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

/// The interval as a form; `r` is that of the enclosed function.
template <class Real>
Beam<Real> interval_form(const Interval<Real>& a, const Real& r) {
    return {centred(a), r, largest(a)};
}

/// The interval as a factor of a derivative: its r covers the rounding of its middle.
template <class Real>
Beam<Real> factor(const Interval<Real>& a) {
    return interval_form(a, largest(a));
}

}  // namespace zeroset
