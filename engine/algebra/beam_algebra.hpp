#pragma once

#include "engine/algebra/beam_branches.hpp"
#include "engine/algebra/beam_elementary.hpp"
#include "engine/algebra/beam_field.hpp"
#include "engine/num/beam_log_sum.hpp"

namespace zeroset {

/// Beam forms of value and derivative, over any carrier, in upward rounding.
template <class Real>
class BeamAlgebra : public BeamElementary<Real>, public BeamBranches<Real>, public BeamField<Real> {
    using Rules = BeamRules<Real>;
    using Rules::box;
    using Rules::format;
    using Rules::joined_slope;
    using Rules::negated;
    using Rules::of;
    using Rules::sum;
    using Rules::times;
    using typename Rules::Box;
    using typename Rules::Form;
    using typename Rules::Slope;

public:
    using typename Rules::In;
    using typename Rules::Value;

    using BeamBranches<Real>::BeamBranches;

    Value negate(In a) { return of(-a.value.f, negated(a.value.slope), a); }
    Value add(In a, In b) {
        return of(a.value.f + b.value.f, sum(a.value.slope, b.value.slope), a, b);
    }
    Value subtract(In a, In b) {
        return of(a.value.f - b.value.f, sum(a.value.slope, negated(b.value.slope)), a, b);
    }
    Value multiply(In a, In b) {
        if (const auto c = exact_factor(a)) return multiple(b, *c);
        if (const auto c = exact_factor(b)) return multiple(a, *c);
        return of(a.value.f * b.value.f,
                  sum(times(a.value.f, b.value.slope), times(b.value.f, a.value.slope)), a, b);
    }
    Value divide(In a, In b) {
        const Box divisor = box(b);
        const Form reciprocal = zeroset::reciprocal(b.value.f, divisor);
        const Form quotient = a.value.f * reciprocal;
        const Slope rest = sum(a.value.slope, negated(times(quotient, b.value.slope)));
        Value result = of(quotient, times(reciprocal, rest), a, b);
        const auto nonzero = no(contains_zero(divisor));
        result.everywhere = conjunction(result.everywhere, {nonzero});
        if (b.facts.exact() && b.facts.constant->hi == 0) result.somewhere = {nonzero};
        return result;
    }
    Value int_power(In a, int n) {
        const Form below = power(a.value.f, n - 1);
        return of(power(a.value.f, n), times(scale(below, n), a.value.slope), a);
    }
    Value log_sum(In a, In b) {
        const Kink<Real> kink = kink_of((a.value.f - b.value.f).range());
        const auto first = a.value.f.f.c >= b.value.f.f.c;
        const LogSumBeam<Real> form = zeroset::log_sum(a.value.f, b.value.f, first, kink);
        const auto slope = [&](const SlopeBeam<Real>& slope_a, const SlopeBeam<Real>& slope_b) {
            const SlopeBeam<Real> larger_one = select(first, slope_a, slope_b);
            const SlopeBeam<Real> smaller_one = select(first, slope_b, slope_a);
            return larger_one + form.share * (smaller_one + -larger_one);
        };
        return of(form.sum, joined_slope(a, b, slope), a, b);
    }

private:
    /// A constant factor that is a number of the format.
    static std::optional<double> exact_factor(In a) {
        if (!a.facts.exact() || !representable(a.facts.constant->hi, format(a))) return {};
        return a.facts.constant->hi;
    }
    static Value multiple(In a, double c) {
        const Slope slope = a.value.slope ? Slope(scale(*a.value.slope, c)) : Slope();
        return of(scale(a.value.f, c), slope, a);
    }
};

}  // namespace zeroset
