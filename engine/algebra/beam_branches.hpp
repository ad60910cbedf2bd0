#pragma once

#include "engine/algebra/beam_polar_algebra.hpp"
#include "engine/algebra/switches.hpp"
#include "engine/num/beam_smooth_min.hpp"
#include "engine/num/fold.hpp"
#include "engine/num/steps.hpp"

namespace zeroset {

/// Operators of BeamAlgebra that jump, decide or choose between forms.
template <class Real>
class BeamBranches : public BeamPolarAlgebra<Real> {
protected:
    using Rules = BeamRules<Real>;
    using typename Rules::Box;
    using typename Rules::Mask;
    using typename Rules::Slope;
    using BeamPolarAlgebra<Real>::turn;
    using BeamPolarAlgebra<Real>::turning;
    using Rules::box;
    using Rules::format;
    using Rules::joined_slope;
    using Rules::negated;
    using Rules::no_slope;
    using Rules::number;
    using Rules::of;
    using Rules::one;
    using Rules::stepped_form;
    using Rules::sum;
    using Rules::times;
    using Rules::with_domain;

public:
    using typename Rules::Form;
    using typename Rules::In;
    using typename Rules::Value;

    BeamBranches() = default;
    explicit BeamBranches(SwitchBoard<Real>* board) : switches_(board) {}

    /// The next operator is this switch, or none.
    void enter(SwitchIndex index) { switches_.enter(index); }

    Value abs(In a) {
        const Kink<Real> kink = kink_of(box(a));
        report(kink);
        Value result = of(zeroset::abs(a.value.f, kink), std::nullopt, a);
        if (a.value.slope) {
            const SlopeBeam<Real>& slope = *a.value.slope;
            result.slope =
                select(kink.above, slope, select(kink.below, -slope, hull(slope, -slope)));
        }
        return result;
    }
    /// The fold of engine/num/fold.hpp, with the integer that is nearest to the middle.
    Value fold(In a) {
        const Form& x = a.value.f;
        const auto [n, odd] = fold_at(x.f.c);
        Affine<Real> moved = x.f;
        moved.c = x.f.c - n;  // exact: n is near
        const Form v{moved, x.r, magnitude(moved.c) + x.spread()};
        const Box range = v.range();
        const Kink<Real> kink = kink_of(range);
        report(kink);
        const Form size = zeroset::abs(v, kink);
        const Form turned = interval_form(one(a), number(a, 0)) - size;
        const auto within_reach = both(range.neg_lo <= number(a, 1), range.hi <= number(a, 1));
        const Form any = interval_form(Box{number(a, 0), number(a, 1)}, x.r + number(a, 2));
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
    Value sign(In a) {
        const Box signs = zeroset::sign_steps(box(a));
        return jump(signs, a, number(a, 0));
    }
    Value floor(In a) {
        const Box floors = zeroset::floor_steps(box(a));
        return jump(floors, a, floors.hi);
    }
    Value ceil(In a) {
        const Box ceilings = zeroset::ceil_steps(box(a));
        return jump(ceilings, a, -ceilings.neg_lo);
    }
    Value round(In a) {
        const Box integers = zeroset::round_steps(box(a));
        return jump(integers, a, integers.hi - number(a, 0.5));
    }
    /// a - b k where floor(a/b) is k on the whole cell. Elsewhere an evaluation may round a/b
    /// across a whole number, and so leave the range.
    Value mod(In a, In b) {
        const Box quotient = box(a) / box(b);
        const Box all_floors = zeroset::floor_steps(quotient);
        if (switches_.wants_cuts()) {
            const Form level = interval_form(point(all_floors.hi), number(a, 0));
            tell_cut(all_floors, a.value.f - b.value.f * level);
        }
        const Box floors = switches_.outcomes(all_floors);
        const Enclosure<Real> range = zeroset::mod(box(a), box(b), floors);
        const Form steps = interval_form(point(floors.hi), number(a, 0));
        const Form line = a.value.f - b.value.f * steps;
        const Real turns = largest(quotient) + number(a, 1);
        const Real r = number(a, 2) * (a.value.f.r + turns * b.value.f.r) +
                       number(a, 6) * turns * largest(box(b));
        const Form f = select(*range.continuous, line, interval_form(range.range, r));
        const Slope slope = sum(a.value.slope, negated(times(steps, b.value.slope)));
        return with_domain(of(f, slope, a, b), range);
    }
    Value min(In a, In b) { return larger(a, b, -1.0); }
    Value max(In a, In b) { return larger(a, b, 1.0); }
    /// The angle on the sides of the cut that the cell has. On one side of it the angle is the one
    /// that goes on across the cut, or that less a turn.
    Value atan2(In y, In x) {
        const Box box_y = box(y);
        const Box box_x = box(x);
        const Box all_sides = angle_sides(box_y, box_x);
        if (switches_.wants_cuts()) tell_cut(all_sides, y.value.f);
        const Box sides = switches_.outcomes(all_sides);
        const Enclosure<Real> g = zeroset::atan2(box_y, box_x, sides);
        const Real angle = elementary(Elementary::Atan2, y.value.f.f.c, x.value.f.f.c);
        const double most = format(y).pi_hi;
        const Box at = clamped(widened(Elementary::Atan2, angle, angle), -most, most);
        const auto cut = angle_cases(box_y, box_x).across_cut;
        const auto above = both(cut, sides.neg_lo < number(y, 0));
        const auto below = both(cut, sides.hi <= number(y, 0));
        const Box none{number(y, 0), number(y, 0)};
        const Box full_turn{number(y, -2 * format(y).pi_lo), number(y, 2 * most)};
        const Box up = select(both(above, angle < number(y, 0)), full_turn, none);
        const Box down = select(both(below, angle >= number(y, 0)), -full_turn, none);
        return turning(g, at + up + down, turn(y, x), y, x);
    }
    Value smooth_min(In a, In b) {
        const Form difference = a.value.f - b.value.f;
        return blend(a, b, difference, blend_sides(difference.range()));
    }
    /// a times the sign of b. That of the value kernels' b is the same where it is known: b is
    /// farther from 0 than their rounding.
    Value oriented(In a, In b) {
        const Box divisor = box(b);
        const Real rounding = b.value.f.r * form_rounding(b.value.f.r);
        const auto above = divisor.neg_lo + rounding < number(a, 0);
        const auto below = divisor.hi + rounding < number(a, 0);
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

    Value less(In a, In b) { return compared(zeroset::less(box(a), box(b)), a, b); }
    Value less_equal(In a, In b) { return compared(zeroset::less_equal(box(a), box(b)), a, b); }
    Value logic_and(In a, In b) {
        return decided(switches_.outcomes(minimum(box(a), box(b))), a, b);
    }
    Value logic_or(In a, In b) {
        return decided(switches_.outcomes(maximum(box(a), box(b))), a, b);
    }
    Value logic_not(In a) {
        const Box condition = box(a);
        return decided(switches_.outcomes(one(a) - condition), a);
    }
    /// a where the condition c holds, b elsewhere; between both where c is undecided.
    Value choose(In c, In a, In b) {
        const Box condition = box(c);
        const Enclosure<Real> of_c{condition, c.value.somewhere, c.value.everywhere,
                                   c.value.continuous};
        const auto side = [&](In x) {
            return Enclosure<Real>{box(x), x.value.somewhere, x.value.everywhere,
                                   x.value.continuous};
        };
        const Enclosure<Real> both_sides = zeroset::choose(of_c, side(a), side(b));
        const auto holds = no(may_fail(condition));
        const auto fails = no(may_hold(condition));
        const Form undecided =
            interval_form(both_sides.range, larger_bound(a.value.f.r, b.value.f.r));
        const Form f = select(holds, a.value.f, select(fails, b.value.f, undecided));
        const SlopeBeam<Real> zero = no_slope(a);
        const SlopeBeam<Real>& slope_a = a.value.slope ? *a.value.slope : zero;
        const SlopeBeam<Real>& slope_b = b.value.slope ? *b.value.slope : zero;
        return {.f = f,
                .slope = select(holds, slope_a, slope_b),
                .somewhere = both_sides.somewhere,
                .everywhere = both_sides.everywhere,
                .continuous = both_sides.continuous};
    }
    /// a where the condition c holds, undefined elsewhere.
    Value where(In a, In c) {
        Value result = a.value;
        const Box condition = box(c);
        result.somewhere =
            conjunction(conjunction(a.value.somewhere, c.value.somewhere), {may_hold(condition)});
        result.everywhere = conjunction(conjunction(a.value.everywhere, c.value.everywhere),
                                        {no(may_fail(condition))});
        return result;
    }

    /// The larger one, or the smaller for `sign` -1; `kink` is that of a - b.
    Value larger(In a, In b, const Kink<Real>& kink, double sign) {
        report(kink);
        const Form form = zeroset::larger(a.value.f, b.value.f, kink, sign);
        const auto slope = [&](const SlopeBeam<Real>& slope_a, const SlopeBeam<Real>& slope_b) {
            const SlopeBeam<Real>& if_above = sign > 0 ? slope_a : slope_b;
            const SlopeBeam<Real>& if_below = sign > 0 ? slope_b : slope_a;
            return select(kink.above, if_above,
                          select(kink.below, if_below, hull(slope_a, slope_b)));
        };
        return of(form, joined_slope(a, b, slope), a, b);
    }
    /// The smooth minimum; `difference`: a - b.
    Value blend(In a, In b, const Form& difference, const BlendSides<Mask>& sides) {
        const Form form = zeroset::smooth_min(a.value.f, b.value.f, difference, sides);
        const auto slope = [&](const SlopeBeam<Real>& slope_a, const SlopeBeam<Real>& slope_b) {
            const SlopeBeam<Real> blended =
                slope_b + blend_share(difference) * (slope_a + -slope_b);
            return select(sides.first, slope_a, select(sides.second, slope_b, blended));
        };
        return of(form, joined_slope(a, b, slope), a, b);
    }

private:
    /// A number of these outcomes, which changes where `a` is `level`, if there are two.
    Value jump(const Box& outcomes, In a, const Real& level) {
        if (switches_.wants_cuts()) {
            tell_cut(outcomes, a.value.f - interval_form(point(level), number(a, 0)));
        }
        return stepped_form(stepped(switches_.outcomes(outcomes)), a);
    }
    Value compared(const Box& outcomes, In a, In b) {
        if (switches_.wants_cuts()) tell_cut(outcomes, a.value.f - b.value.f);
        return decided(switches_.outcomes(outcomes), a, b);
    }
    /// Tells where the switch at work may change: where `f` vanishes.
    void tell_cut(const Box& outcomes, const Form& f) {
        if (!f.f.k[2]) return;
        const Real& slope = *f.f.k[2];
        const Real reciprocal = like(slope, 1.0) / slope;
        switches_.report_cut(no(outcomes.neg_lo == -outcomes.hi), -(f.f.c * reciprocal),
                             (f.spread() - magnitude(slope)) * magnitude(reciprocal));
    }
    /// A condition: decided, it is continuous even where its operands jump.
    template <class... Operands>
    static Value decided(const Box& outcomes, const Operands&... operands) {
        const Enclosure<Real> g = stepped(outcomes);
        Value result = stepped_form(g, operands...);
        result.continuous = g.continuous;
        return result;
    }
    void report(const Kink<Real>& kink) {
        switches_.report_kink(no(either(kink.above, kink.below)));
    }

    Value larger(In a, In b, double sign) {
        return larger(a, b, kink_of((a.value.f - b.value.f).range()), sign);
    }

    SwitchPort<Real> switches_;
};

}  // namespace zeroset
