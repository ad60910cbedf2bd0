#pragma once

#include "engine/algebra/beam_rules.hpp"
#include "engine/num/beam_angle.hpp"
#include "engine/num/beam_polar.hpp"

namespace zeroset {

/// Operators of BeamAlgebra on points in polar coordinates.
template <class Real>
class BeamPolarAlgebra : public BeamRules<Real> {
protected:
    using Rules = BeamRules<Real>;
    using Rules::box;
    using Rules::format;
    using Rules::no_slope;
    using Rules::number;
    using Rules::of;
    using Rules::sum;
    using Rules::times;
    using Rules::with_domain;
    using typename Rules::Form;
    using typename Rules::Slope;

public:
    using typename Rules::Box;
    using typename Rules::In;
    using typename Rules::Value;

    Value angle(In y, In x) {
        const Real angle = elementary(Elementary::Atan2, y.value.f.f.c, x.value.f.f.c);
        const Box at = widened(Elementary::Atan2, angle, angle);
        const auto around_origin = angle_cases(box(y), box(x)).around_origin;
        const Turn<Real> turned = turn(y, x);
        // A convex cell beside the origin is seen under less than a half turn.
        const Real most = number(x, format(x).pi_hi);
        const Real far = minimum(
            largest(turned.by_y) * y.value.f.spread() + largest(turned.by_x) * x.value.f.spread(),
            most);
        const Box beside = at + within<Real>(far);
        const Box range = select(around_origin, within<Real>(most), beside);
        return turning({range, {}, no(around_origin), no(around_origin)}, at, turned, y, x);
    }
    Value angle_sin(In y, In x, int n) {
        return wave(y, x, n, [n](const PolarBeam<Real>& p) { return multiple_sin_at(p, n); });
    }
    Value angle_cos(In y, In x, int n) {
        return wave(y, x, n,
                    [n](const PolarBeam<Real>& p) { return derivative(multiple_sin_at(p, n)); });
    }
    Value length(In y, In x) {
        const PolarBeam<Real> p = polar_beam(y.value.f, x.value.f);
        Slope slope;
        if (y.value.slope || x.value.slope) slope = length_slope(p, polar_slope_of(p, y, x));
        return of(length_form(p, y.value.f, x.value.f), slope, y, x);
    }

protected:
    static Turn<Real> turn(In y, In x) { return turn_of(y.value.f, x.value.f, box(y), box(x)); }
    static Value turning(const Enclosure<Real>& g, const Box& at, Turn<Real> turn, In y, In x) {
        // No plane goes across the cut.
        if (g.continuous) {
            turn.curvature = select(*g.continuous, turn.curvature, like(turn.curvature, infinity));
        }
        const Form f = angle_form(y.value.f, x.value.f, turn, at, g.range);
        const auto [by_y, by_x] = angle_slopes(y.value.f, x.value.f, turn);
        const Slope slope = sum(times(by_y, y.value.slope), times(by_x, x.value.slope));
        return with_domain(of(f, slope, y, x), g);
    }

private:
    /// A wave of n times the angle, `at_middle(polar beam)` what it is there.
    Value wave(In y, In x, int n, auto at_middle) {
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
    static PolarSlope<Real> polar_slope_of(const PolarBeam<Real>& p, In y, In x) {
        const SlopeBeam<Real> none = no_slope(x);
        return polar_slope(p, y.value.slope.value_or(none), x.value.slope.value_or(none));
    }
};

}  // namespace zeroset
