#pragma once

#include "engine/algebra/beam_rules.hpp"
#include "engine/algebra/field_enclosure.hpp"
#include "engine/num/beam_functions.hpp"

#include <array>

namespace zeroset {

/// Fields in BeamAlgebra.
template <class Real>
class BeamField : public BeamRules<Real> {
    using Rules = BeamRules<Real>;
    using Rules::box;
    using Rules::of;
    using Rules::sum;
    using Rules::times;
    using Rules::with_domain;
    using typename Rules::Box;
    using typename Rules::Form;
    using typename Rules::Slope;

public:
    using typename Rules::In;
    using typename Rules::Value;

    Value field(In x, In y, In z, const Field& field, int derivative) {
        return derivative == 0 ? smooth_field(x, y, z, field)
                               : derived_field(x, y, z, field, derivative);
    }

private:
    static auto boxes(In x, In y, In z) {
        const Box a = box(x);
        const Box b = box(y);
        const Box c = box(z);
        return std::array<Real, 6>{a.neg_lo, b.neg_lo, c.neg_lo, a.hi, b.hi, c.hi};
    }

    /// By the mean value theorem, from the middles of the operands; or the range.
    static Value smooth_field(In x, In y, In z, const Field& field) {
        const auto [x0, y0, z0, x1, y1, z1] = boxes(x, y, z);
        const auto out = answers(FieldForm(), field, 0,
                                 std::array<Real, 9>{x0, y0, z0, x1, y1, z1, x.value.f.f.c,
                                                     y.value.f.f.c, z.value.f.f.c});
        const auto g = field_enclosure<FieldForm>(field, 0, out);
        const auto slope_by = [&](std::size_t i) {
            const std::size_t at = FieldForm::slopes + 2 * i;
            return Box{out[at], out[at + 1]};
        };
        const std::array<const Value*, 3> operands{&x.value, &y.value, &z.value};
        Affine<Real> form = centred(Box{out[FieldForm::at_middle], out[FieldForm::at_middle + 1]});
        Real r = out[FieldForm::rounding];
        const Real roundings = like(r, 8 * format_of(r).relative_gap);
        Slope slope;
        for (std::size_t i = 0; i < 3; ++i) {
            const Form& operand = operands[i]->f;
            const Affine<Real> steepness = centred(slope_by(i));
            Affine<Real> moved = operand.f;
            moved.c = like(r, 0.0);
            form = form + scaled(moved, steepness.c);
            form.e = form.e + (steepness.e + roundings * magnitude(steepness.c)) * operand.spread();
            r = r + zeroset::largest(slope_by(i)) * operand.r;
            slope = sum(slope, times(factor(slope_by(i)), operands[i]->slope));
        }
        const Real width = g.range.neg_lo + g.range.hi;
        const auto better = form.e + form.e < width;  // false where NaN
        return with_domain(
            of(Form{form_or_interval(better, form, g.range), r, zeroset::largest(g.range)}, slope,
               x, y, z),
            g);
    }

    /// A derivative jumps between the parts of a field: nothing is known of its own slope.
    static Value derived_field(In x, In y, In z, const Field& field, int derivative) {
        const auto in = boxes(x, y, z);
        const auto g = field_enclosure<FieldRange>(field, derivative,
                                                   answers(FieldRange(), field, derivative, in));
        const Real infinite = like(g.range.hi, infinity);
        const Real size = zeroset::largest(g.range);
        Real r = like(size, 16.0) * size;
        const std::array<const Value*, 3> operands{&x.value, &y.value, &z.value};
        for (std::size_t i = 0; i < 3 && order_of(derivative) < highest_order; ++i) {
            const auto bend = answers(FieldRange(), field, once_more_by(derivative, i), in);
            r = r + operands[i]->f.r * zeroset::largest(Box{bend[0], bend[1]});
        }
        const SlopeBeam<Real> unknown{{like(size, 0.0), {}, infinite}, infinite};
        return with_domain(of(interval_form(g.range, r), unknown, x, y, z), g);
    }
};

}  // namespace zeroset
