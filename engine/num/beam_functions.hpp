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

/// What is known of a function g of one variable over the range of its operand x.
template <class Real>
struct FunctionBounds {
    Interval<Real> range;      ///< of g
    Interval<Real> slope;      ///< of g'
    Interval<Real> at_middle;  ///< of g(c)
    double rounding_ulp;       ///< of an evaluation at a point
};

/// g's r: that of the operand by the greatest slope, and its own.
template <class Real>
Real rounding_of(const FunctionBounds<Real>& g, const Real& operand_r, const Real& size) {
    return largest(g.slope) * operand_r + like(size, g.rounding_ulp) * size;
}

/// g(x) from a line of slope `alpha` through g(c), where |g(x) - g(c) - alpha (x - c)| is at most
/// `error`; or from its range, where that is narrower.
template <class Real>
Beam<Real> along_line(const Beam<Real>& x, const FunctionBounds<Real>& g, const Real& alpha,
                      const Real& error) {
    const Affine<Real> middle = centred(g.at_middle);
    const Real zero = like(alpha, 0.0);
    Affine<Real> moved = x.f;
    moved.c = zero;
    const Affine<Real> line = linear_map(moved, alpha, middle.c, error + middle.e);
    const Real width = g.range.neg_lo + g.range.hi;
    const auto better = line.e + line.e < width;  // false where NaN
    const Real size = largest(g.range);
    return {form_or_interval(better, line, g.range), rounding_of(g, x.r, size), size};
}

/// By the mean value theorem: the slope of g over the range less its middle bounds the error.
template <class Real>
Beam<Real> by_slope(const Beam<Real>& x, const FunctionBounds<Real>& g) {
    const Affine<Real> slope = centred(g.slope);
    return along_line(x, g, slope.c, slope.e * x.spread());
}

/// By Taylor's theorem: `slope_at_middle` encloses g'(c), `curvature` is an upper bound of |g''|.
template <class Real>
Beam<Real> by_curvature(const Beam<Real>& x, const FunctionBounds<Real>& g,
                        const Interval<Real>& slope_at_middle, const Real& curvature) {
    const Affine<Real> slope = centred(slope_at_middle);
    const Real& d = x.spread();
    return along_line(x, g, slope.c, (slope.e + like(d, 0.5) * curvature * d) * d);
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
struct Wave {
    FunctionBounds<Real> bounds;
    Interval<Real> slope_at_middle;
    Real curvature;
};

template <class Real>
Wave<Real> wave_over(const Beam<Real>& x, const WaveAtMiddle<Real>& middle) {
    const Real one = like(x.r, 1.0);
    const Real d = x.spread();
    const Real steepest = minimum(largest(middle.slope) + d, one);
    const Real highest = minimum(largest(middle.value) + d, one);
    const Interval<Real> range = wave_near(middle.value, d * steepest);
    const Interval<Real> slope = wave_near(middle.slope, d * highest);
    return {{range, slope, middle.value, 4.0}, middle.slope, largest(range)};
}

template <class Real>
Beam<Real> wave(const Beam<Real>& x, const Wave<Real>& wave) {
    return by_curvature(x, wave.bounds, wave.slope_at_middle, wave.curvature);
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
            rounding_of(g, x.r, size), size};
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
    const Real most = maximum(per_low + beta * low, per_high + beta * high);
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
    const Real size = maximum(a.size, b.size);
    // Where one of the forms is taken as it is, nothing is rounded.
    const Real rounding =
        select(either(kink.above, kink.below), like(a.r, 0.0), like(a.r, 4.0) * size);
    return {f, maximum(a.r, b.r) + rounding, size};
}

/// Between two forms: w a + (1 - w) b, whatever w in [0, 1].
template <class Real>
Beam<Real> hull(const Beam<Real>& a, const Beam<Real>& b) {
    const Real half = like(a.r, 0.5);
    const Beam<Real> middle = scale(a + b, 0.5);
    Affine<Real> f = middle.f;
    f.e = f.e + half * largest(a.f - b.f);
    return {f, middle.r, middle.size};
}

template <class Mask, class Real>
Beam<Real> select(const Mask& condition, const Beam<Real>& a, const Beam<Real>& b) {
    Affine<Real> f{select(condition, a.f.c, b.f.c), {}, select(condition, a.f.e, b.f.e)};
    const Real zero = like(a.r, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!a.f.k[i] && !b.f.k[i]) continue;
        f.k[i] = select(condition, a.f.k[i].value_or(zero), b.f.k[i].value_or(zero));
    }
    return {f, select(condition, a.r, b.r), select(condition, a.size, b.size)};
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

/// g(a, b), from its range and partial derivatives over the operands' ranges and its value at their
/// middles, by the mean value theorem.
template <class Real>
struct SurfaceBounds {
    Interval<Real> range, by_a, by_b, at_middle;
    double rounding_ulp;
};

template <class Real>
Beam<Real> by_slopes(const Beam<Real>& a, const Beam<Real>& b, const SurfaceBounds<Real>& g) {
    const Affine<Real> slope_a = centred(g.by_a);
    const Affine<Real> slope_b = centred(g.by_b);
    const Affine<Real> middle = centred(g.at_middle);
    Affine<Real> line = scaled(a.f, slope_a.c) + scaled(b.f, slope_b.c);
    line.c = middle.c;
    line.e = line.e + middle.e + slope_a.e * a.spread() + slope_b.e * b.spread();
    const auto better = line.e + line.e < g.range.neg_lo + g.range.hi;
    const Real size = largest(g.range);
    const Real r =
        largest(g.by_a) * a.r + largest(g.by_b) * b.r + like(size, g.rounding_ulp) * size;
    return {form_or_interval(better, line, g.range), r, size};
}

}  // namespace zeroset
