#pragma once

#include "engine/num/beam_functions.hpp"
#include "engine/num/polar.hpp"

#include <cmath>
#include <cstddef>

// Beam forms of a point (x, y) in polar coordinates, over any carrier, in upward rounding. With c
// the middle of x + iy,
//   (x + iy) / c = 1 + along + i across
// where along and across are forms with the middle 0. For |along| <= S < 1 and |across| <= T,
//   length / |c| - 1 - along     is in [0, T Q / 2]  where Q = T / (1 - S),
//   angle - angle of c - across  is in [-1, 1] (Q S + Q^3 / 3),  and the difference of the angles
//                                                                in [-Q, Q]

namespace zeroset {

template <class Real>
struct PolarBeam {
    using Mask = typename Enclosure<Real>::Mask;

    Mask beside;  ///< far enough from the origin for the bounds above to hold
    PolarPoint<Real> middle;
    Affine<Real> along, across;    ///< e holds all rounding errors
    Real most_along, most_across;  ///< S, T
    Real per_nearest;              ///< 1 / (1 - S)
    Real most_turn;                ///< Q
};

/// a x + b y minus its value at the middles of x and y.
template <class Real>
Affine<Real> linear_part(const Affine<Real>& x, const Real& a, const Affine<Real>& y,
                         const Real& b) {
    Affine<Real> result{like(a, 0.0), {}, fused(magnitude(a), x.e, magnitude(b) * y.e)};
    for (std::size_t i = 0; i < 3; ++i) {
        if (x.k[i]) result.k[i] = *x.k[i] * a;
        if (!y.k[i]) continue;
        result.k[i] = result.k[i] ? fused(*y.k[i], b, *result.k[i]) : *y.k[i] * b;
    }
    return result;
}

template <class Real>
PolarBeam<Real> polar_beam(const Beam<Real>& y, const Beam<Real>& x) {
    const auto number = [&](double value) { return like(x.r, value); };
    const PolarPoint<Real> middle = polar_point(y.f.c, x.f.c);
    const auto form = [](const Beam<Real>& a) { return Affine<Real>{a.f.c, a.f.k, a.error()}; };
    const Affine<Real> form_x = form(x);
    const Affine<Real> form_y = form(y);
    const Real to_x = middle.direction.re * middle.per_length;
    const Real to_y = middle.direction.im * middle.per_length;
    Affine<Real> along = linear_part(form_x, to_x, form_y, to_y);
    Affine<Real> across = linear_part(form_x, -to_y, form_y, to_x);
    // Bound the rounding errors, those of the errors included, by 20 units of the terms.
    const Real spread = (x.spread() + y.spread()) * middle.per_length;
    const Real rounding = spread * number(10 * format_of(spread).relative_gap);
    along.e = along.e + rounding;
    across.e = across.e + rounding;
    const Real most_along = deviation(along);
    const Real most_across = deviation(across);
    const Real one = number(1);
    const Real per_nearest = one / -(most_along - one);
    const Format& format = format_of(one);
    const auto normal = both(middle.square > number(format.smallest_normal * 0x1p30),
                             middle.square <= number(format.largest_finite));
    return {both(normal, most_along <= number(0.5)),
            middle,
            along,
            across,
            most_along,
            most_across,
            per_nearest,
            most_across * per_nearest};
}

/// Form of n times the angle, minus n times the angle of the middle. Its error is infinite near the
/// origin.
template <class Real>
Beam<Real> turn_form(const PolarBeam<Real>& p, int n) {
    const auto number = [&](double value) { return like(p.most_turn, value); };
    const Real& q = p.most_turn;
    Affine<Real> turn = scaled(p.across, number(n));
    const Real bend = q * (p.most_along + number(0.375) * q * q);
    turn.e = select(p.beside, fused(number(n), bend, turn.e), number(infinity));
    const Real nothing = number(0);
    return {turn, nothing, nothing};
}

/// Form of the length of (x, y). Near the origin only bounds are known: 0 and a + (sqrt 2 - 1) b,
/// where a >= b are upper bounds of |x| and |y| in some order.
template <class Real>
Beam<Real> length_form(const PolarBeam<Real>& p, const Beam<Real>& y, const Beam<Real>& x) {
    const auto number = [&](double value) { return like(x.r, value); };
    const Real& most_x = x.largest();
    const Real& most_y = y.largest();
    const Real size =
        fused(number(0x1.aap-2), minimum(most_x, most_y), larger_bound(most_x, most_y));
    const Real& length = p.middle.length;
    Affine<Real> form = scaled(p.along, length);
    const Real half_bend = number(0.25) * p.most_across * p.most_turn * length;
    form.c = length + half_bend;
    form.e = form.e + half_bend;
    const Interval<Real> range{number(0), size};
    // Near the origin the square of the length may underflow or overflow in an evaluation at a
    // point.
    const Format& format = format_of(size);
    const Real lost = number(std::sqrt(format.smallest_normal) / format.relative_gap);
    const Real r = y.r + x.r + number(4) * size;
    const auto finite = size * size <= number(format.largest_finite);
    const Real anywhere = select(finite, r + lost, number(infinity));
    return {form_or_interval(p.beside, form, range), select(p.beside, r, anywhere), size};
}

/// Derivatives of (x, y) along the rays, split into the middle's direction and the one across it.
template <class Real>
struct PolarSlope {
    Affine<Real> outward, around;
    Real size;  ///< bounds the terms of either
};

template <class Real>
PolarSlope<Real> polar_slope(const PolarBeam<Real>& p, const SlopeBeam<Real>& y,
                             const SlopeBeam<Real>& x) {
    const Complex<Real>& to = p.middle.direction;
    const auto turned = [&](const Real& by_x, const Real& by_y) {
        Affine<Real> result = linear_part(x.f, by_x, y.f, by_y);
        result.c = fused(y.f.c, by_y, x.f.c * by_x);
        return result;
    };
    return {turned(to.re, to.im), turned(-to.im, to.re), x.size + y.size};
}

/// Derivative of the angle along the rays: the imaginary part of m / (1 + d) / |c|, with m =
/// outward + i around and d = along + i across; m / (1 + d) is m - m d + m d^2 / (1 + d).
template <class Real>
SlopeBeam<Real> turning_slope(const PolarBeam<Real>& p, const PolarSlope<Real>& m) {
    Affine<Real> rate = m.around - scaled(p.along, m.around.c) - scaled(p.across, m.outward.c);
    const Real off_outward = deviation(m.outward);
    const Real off_around = deviation(m.around);
    const Real largest_m =
        magnitude(m.outward.c) + off_outward + magnitude(m.around.c) + off_around;
    const Real square = fused(p.most_along, p.most_along, p.most_across * p.most_across);
    const Real bend = largest_m * square * p.per_nearest;
    rate.e = rate.e + fused(off_outward, p.most_across, fused(off_around, p.most_along, bend));
    const Real& per_length = p.middle.per_length;
    const Real size = fused(p.most_turn, m.size, m.size) * per_length;
    return rounded(scaled(rate, per_length), like(size, 16.0) * size);
}

/// Derivative of the length along the rays: the real part of m exp(-i turn), with |turn| <= Q. Near
/// the origin it is bounded for any turn.
template <class Real>
SlopeBeam<Real> length_slope(const PolarBeam<Real>& p, const PolarSlope<Real>& m) {
    const auto number = [&](double value) { return like(m.size, value); };
    const Real& q = p.most_turn;
    Affine<Real> rate = m.outward + scaled(p.across, m.around.c);
    const Real most_outward = magnitude(m.outward.c) + deviation(m.outward);
    const Real cosine = number(0.5) * q * q * most_outward;
    const Real sine = q * (p.most_along + p.most_across * q) * magnitude(m.around.c);
    rate.e = rate.e + cosine + fused(deviation(m.around), q, sine);
    const Affine<Real> any{number(0), {}, m.size};
    const Real size = select(p.beside, fused(q, m.size, m.size), m.size);
    return rounded(select(p.beside, rate, any), number(16) * size);
}

/// A sine or cosine of n times the angle, and its derivative by n times the angle, at the middle;
/// both are off by at most `error`.
template <class Real>
struct WavePoint {
    Real value, slope;
    Real error;
};

template <class Real>
WavePoint<Real> multiple_sin_at(const PolarBeam<Real>& p, int n) {
    const Complex<Real> wave = power(p.middle.direction, n);
    const double unit = 0.5 * format_of(wave.re).relative_gap;
    return {wave.im, wave.re, like(wave.re, unit * power_error(n))};
}
/// Derivative of a wave: the wave a quarter of a turn ahead.
template <class Real>
WavePoint<Real> derivative(const WavePoint<Real>& wave) {
    return {wave.slope, -wave.value, wave.error};
}

/// Form of a wave g by Taylor's theorem with g'' = -g, or its range where that is narrower. `turn`
/// is the operand minus its middle. The roundings made here are below 12 units.
template <class Real>
Beam<Real> wave_along(const Beam<Real>& turn, const WavePoint<Real>& at) {
    const auto number = [&](double value) { return like(turn.r, value); };
    const Real one = number(1);
    const Real half = number(0.5);
    const Real& d = turn.spread();
    // Bound the range by the mean value theorem.
    const Real steepest = minimum(magnitude(at.slope) + at.error + d, one);
    const Real far = fused(steepest, d, at.error);
    // Upper bounds of g and -g, 1 where NaN.
    const Real hi = minimum(at.value + far, one);
    const Real neg_lo = minimum(far - at.value, one);
    // Bound the remainder of Taylor's theorem by the range of g.
    const Real half_square = half * d * d;
    const Real above = maximum(neg_lo, number(0)) * half_square;
    const Real below = maximum(hi, number(0)) * half_square;
    Affine<Real> form = scaled(turn.f, at.slope);
    form.c = at.value + half * (above - below);
    form.e = form.e + half * (above + below) + fused(at.error, d, at.error);
    const Real width = hi + neg_lo;
    const auto better = form.e + form.e < width;  // false where NaN
    const Affine<Real> range{half * (hi - neg_lo), {}, half * width};
    return {select(better, form, range), number(4), one};
}

/// Form of a wave of n times the angle; `turn` is turn_form(p, n), `at` the wave at the middle.
template <class Real>
Beam<Real> wave_form(const PolarBeam<Real>& p, const Beam<Real>& y, const Beam<Real>& x,
                     const Beam<Real>& turn, const WavePoint<Real>& at, int n) {
    const auto number = [&](double value) { return like(x.r, value); };
    const Beam<Real> form = wave_along(turn, at);
    const Complex<Real>& to = p.middle.direction;
    const Real by_y = magnitude(to.re) + p.most_turn;
    const Real by_x = magnitude(to.im) + p.most_turn;
    const Real steepest = minimum(magnitude(at.slope) + turn.spread() + at.error, number(1));
    const Real by_turn = number(n) * steepest * p.middle.per_length * p.per_nearest;
    const Real r = fused(by_turn, fused(by_y, y.r, by_x * x.r), number(power_error(n)) + form.r);
    return {form.f, select(p.beside, r, form.r), form.size};
}

}  // namespace zeroset
