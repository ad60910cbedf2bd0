#pragma once

#include "engine/algebra/beam_algebra.hpp"

// Operators of BeamAlgebra that choose between forms.

namespace zeroset {

/// a - b k where floor(a/b) is k on the whole cell. Elsewhere an evaluation may round a/b across a
/// whole number, and so leave the range.
template <class Real>
BeamValue<Real> BeamAlgebra<Real>::mod(In a, In b) {
    const Box quotient = box(a) / box(b);
    const Box all_floors = zeroset::floor_steps(quotient);
    if (switches_.wants_cuts()) {
        const Form level = interval_form(point(all_floors.hi), number(0));
        tell_cut(all_floors, a.value.f - b.value.f * level);
    }
    const Box floors = switches_.outcomes(all_floors);
    const Enclosure<Real> range = zeroset::mod(box(a), box(b), floors);
    const Form steps = interval_form(point(floors.hi), number(0));
    const Form line = a.value.f - b.value.f * steps;
    const Real turns = largest(quotient) + number(1);
    const Real r =
        number(2) * (a.value.f.r + turns * b.value.f.r) + number(6) * turns * largest(box(b));
    const Form f = select(*range.continuous, line, interval_form(range.range, r));
    const Slope slope = sum(a.value.slope, negated(times(steps, b.value.slope)));
    return with_domain(of(f, slope, a, b), range);
}

/// The angle on the sides of the cut that the cell has. On one side of it the angle is the one that
/// goes on across the cut, or that less a turn.
template <class Real>
BeamValue<Real> BeamAlgebra<Real>::atan2(In y, In x) {
    const Box box_y = box(y);
    const Box box_x = box(x);
    const Box all_sides = angle_sides(box_y, box_x);
    if (switches_.wants_cuts()) tell_cut(all_sides, y.value.f);
    const Box sides = switches_.outcomes(all_sides);
    const Enclosure<Real> g = zeroset::atan2(box_y, box_x, sides);
    const Real angle = elementary(Elementary::Atan2, y.value.f.f.c, x.value.f.f.c);
    const double most = format().pi_hi;
    const Box at = clamped(widened(Elementary::Atan2, angle, angle), -most, most);
    const auto cut = angle_cases(box_y, box_x).across_cut;
    const auto above = both(cut, sides.neg_lo < number(0));
    const auto below = both(cut, sides.hi <= number(0));
    const Box none{number(0), number(0)};
    const Box turn{number(-2 * format().pi_lo), number(2 * most)};
    const Box up = select(both(above, angle < number(0)), turn, none);
    const Box down = select(both(below, angle >= number(0)), -turn, none);
    return turning(g, at + up + down, this->turn(y, x), y, x);
}

/// a where the condition c holds, b elsewhere; between both where c is undecided.
template <class Real>
BeamValue<Real> BeamAlgebra<Real>::choose(In c, In a, In b) {
    const Box condition = box(c);
    const Enclosure<Real> of_c{condition, c.value.somewhere, c.value.everywhere,
                               c.value.continuous};
    const auto side = [&](In x) {
        return Enclosure<Real>{box(x), x.value.somewhere, x.value.everywhere, x.value.continuous};
    };
    const Enclosure<Real> both_sides = zeroset::choose(of_c, side(a), side(b));
    const auto holds = no(may_fail(condition));
    const auto fails = no(may_hold(condition));
    const Form undecided = interval_form(both_sides.range, larger_bound(a.value.f.r, b.value.f.r));
    const Form f = select(holds, a.value.f, select(fails, b.value.f, undecided));
    const SlopeBeam<Real> zero = no_slope();
    const SlopeBeam<Real>& slope_a = a.value.slope ? *a.value.slope : zero;
    const SlopeBeam<Real>& slope_b = b.value.slope ? *b.value.slope : zero;
    return {f, select(holds, slope_a, slope_b), both_sides.somewhere, both_sides.everywhere,
            both_sides.continuous};
}

/// As fold in engine/num/fold.hpp, with the integer that is nearest to the middle.
template <class Real>
BeamValue<Real> BeamAlgebra<Real>::fold(In a) {
    const Form& x = a.value.f;
    kind_ = &x.r;
    const auto [n, odd] = fold_at(x.f.c);
    Affine<Real> moved = x.f;
    moved.c = x.f.c - n;  // exact: n is near
    const Form v{moved, x.r, magnitude(moved.c) + x.spread()};
    const Box range = v.range();
    const Kink<Real> kink = kink_of(range);
    report(kink);
    const Form size = zeroset::abs(v, kink);
    const Form turned = interval_form(point(number(1)), number(0)) - size;
    const auto within_reach = both(range.neg_lo <= number(1), range.hi <= number(1));
    const Form any = interval_form(Box{number(0), number(1)}, x.r + number(2));
    Value result = of(select(within_reach, select(odd, turned, size), any), std::nullopt, a);
    if (a.value.slope) {
        const SlopeBeam<Real>& rising = *a.value.slope;
        const SlopeBeam<Real> either_way = hull(rising, -rising);
        const SlopeBeam<Real> of_size =
            select(kink.above, rising, select(kink.below, -rising, either_way));
        result.slope = select(within_reach, select(odd, -of_size, of_size), either_way);
    }
    return result;
}

/// a times the sign of b. That of the value kernels' b is the same where it is known: b is farther
/// from 0 than their rounding.
template <class Real>
BeamValue<Real> BeamAlgebra<Real>::oriented(In a, In b) {
    const Box divisor = box(b);
    const Real rounding = b.value.f.r * form_rounding(b.value.f.r);
    const auto above = divisor.neg_lo + rounding < number(0);
    const auto below = divisor.hi + rounding < number(0);
    const auto known = either(above, below);
    const auto turned = [&](const auto& f) { return select(below, -f, f); };
    const Form zeros = turned(a.value.zeros.value_or(a.value.f));
    const Real far = magnitude(a.value.f.f.c) + a.value.f.spread();
    const Form either_way = interval_form(within<Real>(far), a.value.f.r);
    Value result = of(select(known, turned(a.value.f), either_way), std::nullopt, a, b);
    if (a.value.slope) {
        const SlopeBeam<Real>& slope = *a.value.slope;
        result.slope = select(known, turned(slope), hull(slope, -slope));
    }
    result.zeros = zeros;
    result.everywhere = conjunction(result.everywhere, {known});
    if (b.facts.exact() && b.facts.constant->hi == 0) result.somewhere = {known};
    return result;
}

/// a where the condition c holds, undefined elsewhere.
template <class Real>
BeamValue<Real> BeamAlgebra<Real>::where(In a, In c) {
    Value result = a.value;
    const Box condition = box(c);
    result.somewhere =
        conjunction(conjunction(a.value.somewhere, c.value.somewhere), {may_hold(condition)});
    result.everywhere =
        conjunction(conjunction(a.value.everywhere, c.value.everywhere), {no(may_fail(condition))});
    return result;
}

}  // namespace zeroset
