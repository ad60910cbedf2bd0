#pragma once

#include "engine/algebra/beam_algebra.hpp"

// Operators of BeamAlgebra on points in polar coordinates.

namespace zeroset {

template <class Real>
PolarSlope<Real> BeamAlgebra<Real>::polar_slope_of(const PolarBeam<Real>& p, In y, In x) {
    kind_ = &x.value.f.r;
    const SlopeBeam<Real> none = no_slope();
    return polar_slope(p, y.value.slope.value_or(none), x.value.slope.value_or(none));
}

/// A wave of n times the angle, `at_middle(polar beam)` what it is there.
template <class Real>
BeamValue<Real> BeamAlgebra<Real>::wave(In y, In x, int n, auto at_middle) {
    const PolarBeam<Real> p = polar_beam(y.value.f, x.value.f);
    const Form turn = turn_form(p, n);
    const auto at = at_middle(p);
    Slope slope;
    if (y.value.slope || x.value.slope) {
        const SlopeBeam<Real> turning = turning_slope(p, polar_slope_of(p, y, x));
        slope = wave_along(turn, derivative(at)) * scale(turning, n);
    }
    Value result = of(wave_form(p, y.value.f, x.value.f, turn, at, n), slope, y, x);
    result.everywhere = conjunction(result.everywhere, {p.beside});
    result.continuous = conjunction(result.continuous, {p.beside});
    return result;
}

template <class Real>
BeamValue<Real> BeamAlgebra<Real>::angle_sin(In y, In x, int n) {
    return wave(y, x, n, [n](const PolarBeam<Real>& p) { return multiple_sin_at(p, n); });
}

template <class Real>
BeamValue<Real> BeamAlgebra<Real>::angle_cos(In y, In x, int n) {
    return wave(y, x, n,
                [n](const PolarBeam<Real>& p) { return derivative(multiple_sin_at(p, n)); });
}

template <class Real>
BeamValue<Real> BeamAlgebra<Real>::length(In y, In x) {
    const PolarBeam<Real> p = polar_beam(y.value.f, x.value.f);
    Slope slope;
    if (y.value.slope || x.value.slope) slope = length_slope(p, polar_slope_of(p, y, x));
    return of(length_form(p, y.value.f, x.value.f), slope, y, x);
}

}  // namespace zeroset
