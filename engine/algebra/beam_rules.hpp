#pragma once

#include "engine/algebra/beam_value.hpp"
#include "engine/num/beam_functions.hpp"

#include <optional>

namespace zeroset {

/// Steps that the operators of BeamAlgebra are made of.
template <class Real>
class BeamRules {
public:
    using Value = BeamValue<Real>;
    using In = const Operand<Value>&;
    using Form = Beam<Real>;
    using Mask = typename Value::Mask;
    using Box = Interval<Real>;
    using Slope = std::optional<SlopeBeam<Real>>;

protected:
    /// A number of the operand's carrier.
    static Real number(In a, double value) { return like(a.value.f.r, value); }
    static const Format& format(In a) { return format_of(a.value.f.r); }
    static Box one(In a) { return point(number(a, 1)); }
    static Box square_of(const Box& a) { return power_nonnegative(absolute(a), 2); }

    /// The range of the operand's form.
    static Box box(In a) { return a.value.f.range(); }
    static Box middle(In a) { return point(a.value.f.f.c); }

    /// The slope 0.
    static SlopeBeam<Real> no_slope(In a) {
        return {{number(a, 0), {}, number(a, 0)}, number(a, 0)};
    }
    /// A slope made of those of a and b, of which an absent one is 0; absent where both are.
    static Slope joined_slope(In a, In b, auto join) {
        if (!a.value.slope && !b.value.slope) return std::nullopt;
        const SlopeBeam<Real> zero = no_slope(a);
        return join(a.value.slope ? *a.value.slope : zero, b.value.slope ? *b.value.slope : zero);
    }
    static Slope negated(const Slope& a) {
        if (!a) return a;
        return -*a;
    }
    static Slope sum(const Slope& a, const Slope& b) {
        if (!a) return b;
        if (!b) return a;
        return *a + *b;
    }
    static Slope times(const Form& a, const Slope& b) {
        if (!b) return b;
        return a * *b;
    }

    /// A function defined and continuous everywhere.
    template <class... Operands>
    static Value of(const Form& f, const Slope& slope, const Operands&... operands) {
        return {.f = f,
                .slope = slope,
                .somewhere = conjunction_of(operands.value.somewhere...),
                .everywhere = conjunction_of(operands.value.everywhere...),
                .continuous = conjunction_of(operands.value.continuous...)};
    }
    template <class Mask>
    static std::optional<Mask> conjunction_of(const std::optional<Mask>& a) {
        return a;
    }
    template <class Mask>
    static std::optional<Mask> conjunction_of(const std::optional<Mask>& a,
                                              const std::optional<Mask>& b) {
        return conjunction(a, b);
    }
    template <class Mask>
    static std::optional<Mask> conjunction_of(const std::optional<Mask>& a,
                                              const std::optional<Mask>& b,
                                              const std::optional<Mask>& c) {
        return conjunction(a, b, c);
    }
    /// A function of one operand with its derivative and its own domain.
    static Value of(const Form& f, const Form& slope, const Enclosure<Real>& domain, In a) {
        return with_domain(of(f, times(slope, a.value.slope), a), domain);
    }
    static Value with_domain(Value f, const Enclosure<Real>& domain) {
        f.somewhere = conjunction(f.somewhere, domain.somewhere);
        f.everywhere = conjunction(f.everywhere, domain.everywhere);
        f.continuous = conjunction(f.continuous, domain.continuous);
        return f;
    }
    static Value curved(const FunctionBounds<Real>& g, const Enclosure<Real>& domain, In a) {
        return of(curve(a.value.f, g), slope_of_curve(a.value.f, g), domain, a);
    }
    /// g(a) from its range and what encloses it at the middle: g' from `slope(x, g(x))`, g'' from
    /// `bend(x, g(x), g'(x))`, over intervals.
    static Value smooth(In a, const Enclosure<Real>& g, const Box& at, double rounding_ulp,
                        auto slope, auto bend) {
        const Box x = a.value.f.range();
        const Box slopes = slope(x, g.range);
        const Box bends = bend(x, g.range, slopes);
        return curved({.range = g.range,
                       .slope = slopes,
                       .curvature = bends,
                       .at_middle = at,
                       .slope_at_middle = slope(middle(a), at),
                       .rounding_ulp = rounding_ulp},
                      g, a);
    }
    /// Constant where it is continuous.
    template <class... Operands>
    static Value stepped_form(const Enclosure<Real>& g, const Operands&... operands) {
        const Real nothing = like(g.range.hi, 0.0);
        return with_domain(of(interval_form(g.range, nothing), std::nullopt, operands...), g);
    }
};

}  // namespace zeroset
