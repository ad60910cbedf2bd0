#pragma once

#include "engine/num/beam_functions.hpp"

// Beam forms of the angle of a point (x, y), over any carrier, in upward rounding. The angle is the
// imaginary part of log(x + iy), so the size of its n-th derivative is at most (n - 1)! / rho^n at
// the distance rho from the origin.

namespace zeroset {

/// Bounds of the angle's partial derivatives over a box and at its middle.
template <class Real>
struct Turn {
    Interval<Real> by_y, by_x;
    Interval<Real> by_y_at_middle, by_x_at_middle;
    Real curvature;  ///< upper bound of 1 / rho^2
    Real square;     ///< upper bound of the squared distance of the box's points from its middle
};

/// Partial derivatives of the angle by y and by x: x / (x^2 + y^2) and -y / (x^2 + y^2).
template <class Real>
std::array<Interval<Real>, 2> slopes_of_angle(const Interval<Real>& y, const Interval<Real>& x) {
    const Interval<Real> square =
        power_nonnegative(absolute(x), 2) + power_nonnegative(absolute(y), 2);
    return {divide_by_nonnegative(x, square), -divide_by_nonnegative(y, square)};
}

template <class Real>
Turn<Real> turn_of(const Beam<Real>& y, const Beam<Real>& x, const Interval<Real>& box_y,
                   const Interval<Real>& box_x) {
    const auto [by_y, by_x] = slopes_of_angle(box_y, box_x);
    const auto [at_y, at_x] = slopes_of_angle(point(y.f.c), point(x.f.c));
    const Interval<Real> square =
        power_nonnegative(absolute(box_x), 2) + power_nonnegative(absolute(box_y), 2);
    const Real one = like(y.r, 1.0);
    return {by_y,
            by_x,
            at_y,
            at_x,
            divide_by_nonnegative(point(one), square).hi,
            y.spread() * y.spread() + x.spread() * x.spread()};
}

/// Form of a function of y and x: the plane through `value` at their middles with slopes `by_y` and
/// `by_x`, off by at most `error`; or `range` where that is narrower. Its r is that of the one
/// taken.
template <class Real>
Beam<Real> along_plane(const Beam<Real>& y, const Beam<Real>& x, const Interval<Real>& value,
                       const Interval<Real>& by_y, const Interval<Real>& by_x, const Real& error,
                       const Interval<Real>& range, const Real& r_of_plane,
                       const Real& r_of_range) {
    const Affine<Real> slope_y = centred(by_y);
    const Affine<Real> slope_x = centred(by_x);
    const Affine<Real> middle = centred(value);
    Affine<Real> plane = scaled(y.f, slope_y.c) + scaled(x.f, slope_x.c);
    plane.c = middle.c;
    plane.e = plane.e + middle.e + error + slope_y.e * y.spread() + slope_x.e * x.spread();
    const auto better = plane.e + plane.e < range.neg_lo + range.hi;  // false where NaN
    return {form_or_interval(better, plane, range), select(better, r_of_plane, r_of_range),
            largest(range)};
}

/// Form of the angle; `at_middle` encloses the angle at the middles, `range` that over the box.
template <class Real>
Beam<Real> angle_form(const Beam<Real>& y, const Beam<Real>& x, const Turn<Real>& turn,
                      const Interval<Real>& at_middle, const Interval<Real>& range) {
    const Real r =
        largest(turn.by_y) * y.r + largest(turn.by_x) * x.r + like(y.r, 4.0) * largest(range);
    const Real error = like(y.r, 0.5) * turn.curvature * turn.square;
    return along_plane(y, x, at_middle, turn.by_y_at_middle, turn.by_x_at_middle, error, range, r,
                       r);
}

/// Forms of the angle's partial derivatives by y and by x.
template <class Real>
std::array<Beam<Real>, 2> angle_slopes(const Beam<Real>& y, const Beam<Real>& x,
                                       const Turn<Real>& turn) {
    const Interval<Real>& by_y = turn.by_y_at_middle;
    const Interval<Real>& by_x = turn.by_x_at_middle;
    // Second derivatives of the angle: yy, which is -xx, and xy.
    const Interval<Real> straight = scale(by_x * by_y, 2.0);
    const Interval<Real> mixed = power(by_x, 2, false) - power(by_y, 2, false);
    // Taylor's remainder: the third derivatives are at most 2 / rho^3.
    const Real error = turn.curvature * square_root(turn.curvature) * turn.square;
    const Real zero = like(y.r, 0.0);
    const Real r_of_slopes = turn.curvature * (y.r + x.r);
    const auto slope = [&](const Interval<Real>& at_middle, const Interval<Real>& along_y,
                           const Interval<Real>& along_x, const Interval<Real>& range) {
        const Real r = r_of_slopes + like(zero, 4.0) * largest(range);
        return along_plane(y, x, at_middle, along_y, along_x, error, range, r, zero);
    };
    return {slope(by_y, straight, mixed, turn.by_y), slope(by_x, mixed, -straight, turn.by_x)};
}

}  // namespace zeroset
