#pragma once

#include "engine/algebra/field_enclosure.hpp"
#include "engine/algebra/operand.hpp"
#include "engine/algebra/switches.hpp"
#include "engine/num/cardinal.hpp"
#include "engine/num/fold.hpp"
#include "engine/num/log_sum.hpp"
#include "engine/num/odd_root.hpp"
#include "engine/num/periodic.hpp"
#include "engine/num/smooth_min.hpp"
#include "engine/num/steps.hpp"

#include <optional>

namespace zeroset {

/// Natural interval extension, with what is known of each node's domain.
template <class Real>
class IntervalAlgebra {
public:
    using Value = Enclosure<Real>;
    using In = const Operand<Value>&;

    IntervalAlgebra() = default;
    explicit IntervalAlgebra(SwitchBoard<Real>* board) : switches_(board) {}

    /// The next operator is this switch, or none.
    void enter(SwitchIndex index) { switches_.enter(index); }

    Value negate(In a) {
        Value g{-range(a)};
        if (a.value.gap) g.gap = -*a.value.gap;
        return composed(g, a.value);
    }
    Value add(In a, In b) {
        Value g{range(a) + range(b)};
        g.gap = sharper(moved(a.value.gap, range(b)), moved(b.value.gap, range(a)));
        return composed(g, a.value, b.value);
    }
    Value subtract(In a, In b) {
        Value g{range(a) - range(b)};
        Gap minus_b;
        if (b.value.gap) minus_b = -*b.value.gap;
        g.gap = sharper(moved(a.value.gap, -range(b)), moved(minus_b, range(a)));
        return composed(g, a.value, b.value);
    }
    Value multiply(In a, In b) {
        Value g{product(a, b)};
        g.gap = sharper(multiplied(a.value.gap, range(b)), multiplied(b.value.gap, range(a)));
        return composed(g, a.value, b.value);
    }
    Value divide(In a, In b) {
        const auto nonzero = excludes_zero(range(b));
        Value g{
            b.facts.nonnegative ? divide_by_nonnegative(range(a), range(b)) : range(a) / range(b),
            {},
            nonzero};
        const Interval<Real> inverse = point(like(range(b).hi, 1.0)) / range(b);
        g.gap = sharper(Gap(quotient_gap(range(a), range(b))), multiplied(a.value.gap, inverse));
        return with_divisor(g, a, b);
    }
    Value int_power(In a, int n) { return total(power(range(a), n, a.facts.nonnegative), a); }
    Value odd_root(In a, int n) { return total(zeroset::odd_root(range(a), n), a); }
    Value sqrt(In a) {
        if (a.facts.nonnegative) return total(square_root(range(a)), a);
        return composed(zeroset::sqrt(range(a)), a.value);
    }
    Value abs(In a) { return total(a.facts.nonnegative ? range(a) : absolute(range(a)), a); }
    Value fold(In a) { return total(zeroset::fold(range(a)), a); }
    Value sign(In a) { return jump(zeroset::sign_steps(range(a)), a); }
    Value floor(In a) { return jump(zeroset::floor_steps(range(a)), a); }
    Value ceil(In a) { return jump(zeroset::ceil_steps(range(a)), a); }
    Value round(In a) { return jump(zeroset::round_steps(range(a)), a); }
    Value mod(In a, In b) {
        const Interval<Real> steps = switches_.outcomes(zeroset::floor_steps(range(a) / range(b)));
        return with_divisor(zeroset::mod(range(a), range(b), steps), a, b);
    }
    Value min(In a, In b) { return chosen(minimum(range(a), range(b)), a, b, a, b); }
    Value max(In a, In b) { return chosen(maximum(range(a), range(b)), a, b, b, a); }

    Value exp(In a) { return total(zeroset::exp(range(a)), a); }
    Value log(In a) { return composed(logarithm(Elementary::Log, range(a)), a.value); }
    Value log10(In a) { return composed(logarithm(Elementary::Log10, range(a)), a.value); }
    Value log2(In a) { return composed(logarithm(Elementary::Log2, range(a)), a.value); }
    Value sin(In a) { return total(zeroset::sin(range(a)), a); }
    Value cos(In a) { return total(zeroset::cos(range(a)), a); }
    Value tan(In a) { return composed(zeroset::tan(range(a)), a.value); }
    Value cot(In a) { return composed(zeroset::cot(range(a)), a.value); }
    Value asin(In a) { return odd(zeroset::asin(range(a)), a); }
    Value acos(In a) { return composed(zeroset::acos(range(a)), a.value); }
    Value atan(In a) { return odd({zeroset::atan(range(a))}, a); }
    Value atan2(In y, In x) {
        const Interval<Real> sides = switches_.outcomes(angle_sides(range(y), range(x)));
        return composed(zeroset::atan2(range(y), range(x), sides), y.value, x.value);
    }
    Value angle(In y, In x) {
        return composed(zeroset::angle(range(y), range(x)), y.value, x.value);
    }
    Value angle_sin(In y, In x, int n) {
        return wave(y, x, n, [](const Interval<Real>& a) { return zeroset::sin(a); });
    }
    Value angle_cos(In y, In x, int n) {
        return wave(y, x, n, [](const Interval<Real>& a) { return zeroset::cos(a); });
    }
    Value length(In y, In x) {
        return total(square_root(power(range(y), 2, y.facts.nonnegative) +
                                 power(range(x), 2, x.facts.nonnegative)),
                     y, x);
    }
    Value sinc(In a) { return total(cardinal(Cardinal::Sin, range(a)), a); }
    Value sinhc(In a) { return total(cardinal(Cardinal::Sinh, range(a)), a); }
    Value atanc(In a) { return total(cardinal(Cardinal::Atan, range(a)), a); }
    Value log_sum(In a, In b) { return total(zeroset::log_sum(range(a), range(b)), a, b); }
    Value smooth_min(In a, In b) { return total(zeroset::smooth_min(range(a), range(b)), a, b); }
    Value oriented(In a, In b) { return with_divisor(zeroset::oriented(a.value, range(b)), a, b); }
    Value sinh(In a) { return odd({odd_increasing(Elementary::Sinh, range(a))}, a); }
    Value cosh(In a) { return total(zeroset::cosh(range(a)), a); }
    Value tanh(In a) { return odd({zeroset::tanh(range(a))}, a); }
    Value asinh(In a) { return odd({odd_increasing(Elementary::Asinh, range(a))}, a); }
    Value acosh(In a) { return composed(zeroset::acosh(range(a)), a.value); }
    Value atanh(In a) { return odd(zeroset::atanh(range(a)), a); }

    Value less(In a, In b) {
        return decided(switches_.outcomes(zeroset::less(range(a), range(b))), a, b);
    }
    Value less_equal(In a, In b) {
        return decided(switches_.outcomes(zeroset::less_equal(range(a), range(b))), a, b);
    }
    Value logic_and(In a, In b) {
        return decided(switches_.outcomes(minimum(range(a), range(b))), a, b);
    }
    Value logic_or(In a, In b) {
        return decided(switches_.outcomes(maximum(range(a), range(b))), a, b);
    }
    Value logic_not(In a) {
        return decided(switches_.outcomes(point(like(range(a).hi, 1.0)) - range(a)), a);
    }
    Value choose(In c, In a, In b) { return zeroset::choose(c.value, a.value, b.value); }
    Value field(In x, In y, In z, const Field& field, int derivative) {
        const auto out =
            answers(FieldRange(), field, derivative,
                    std::array<Real, 6>{range(x).neg_lo, range(y).neg_lo, range(z).neg_lo,
                                        range(x).hi, range(y).hi, range(z).hi});
        const Value g = field_enclosure<FieldRange>(field, derivative, out);
        return composed(composed(g, x.value), y.value, z.value);
    }
    Value where(In a, In c) { return zeroset::where(a.value, c.value); }

private:
    using Gap = std::optional<Interval<Real>>;

    static const Interval<Real>& range(In a) { return a.value.range; }
    static Gap moved(const Gap& gap, const Interval<Real>& by) {
        return gap ? Gap(*gap + by) : std::nullopt;
    }
    static Gap multiplied(const Gap& gap, const Interval<Real>& by) {
        return gap ? Gap(multiply_gap(*gap, by)) : std::nullopt;
    }

    /// A function defined and continuous everywhere.
    template <class... Operands>
    static Value total(const Interval<Real>& g, const Operands&... operands) {
        return composed(Value{g}, operands.value...);
    }
    /// The lesser or larger one of a and b; the other one's jumps do not matter. `if_less`: what it
    /// is where a is less.
    static Value chosen(const Interval<Real>& g, In a, In b, In if_less, In if_more) {
        Value result = total(g, a, b);
        if (!result.continuous) return result;
        const Real zero = like(g.hi, 0.0);
        const auto less = range(a).hi + range(b).neg_lo < zero;
        const auto more = range(a).neg_lo + range(b).hi < zero;
        const auto surely = [](const auto& taken, In of) {
            return of.value.continuous ? both(taken, *of.value.continuous) : taken;
        };
        result.continuous =
            either(*result.continuous, either(surely(less, if_less), surely(more, if_more)));
        return result;
    }
    /// A number of these outcomes.
    Value jump(const Interval<Real>& outcomes, In a) {
        return composed(jumping(switches_.outcomes(outcomes)), a.value);
    }
    /// A condition: decided, it is continuous even where its operands jump.
    template <class... Operands>
    static Value decided(const Interval<Real>& outcomes, const Operands&... operands) {
        Value g = stepped(outcomes);
        const auto continuous = g.continuous;
        g = composed(g, operands.value...);
        g.continuous = continuous;
        return g;
    }
    /// An odd increasing function: not negative where its operand is not.
    static Value odd(Value g, In a) {
        if (a.facts.nonnegative) g.range.neg_lo = minimum(like(g.range.hi, 0.0), g.range.neg_lo);
        return composed(g, a.value);
    }
    /// A wave of n times an angle.
    static Value wave(In y, In x, int n, auto function) {
        Value g = zeroset::angle(range(y), range(x));
        g.range = function(scale(g.range, n));
        return composed(g, y.value, x.value);
    }
    /// Nowhere defined for the divisor 0.
    static Value with_divisor(Value g, In a, In b) {
        if (b.facts.exact() && b.facts.constant->hi == 0) g.somewhere = g.everywhere;
        return composed(g, a.value, b.value);
    }

    static Interval<Real> product(In a, In b) {
        if (const auto range_of_multiple = scaled(b, a)) return *range_of_multiple;
        if (const auto range_of_multiple = scaled(a, b)) return *range_of_multiple;
        if (a.facts.nonnegative && b.facts.nonnegative)
            return multiply_nonnegative(range(a), range(b));
        if (a.facts.nonnegative) return multiply_nonnegative_by(range(a), range(b));
        if (b.facts.nonnegative) return multiply_nonnegative_by(range(b), range(a));
        return range(a) * range(b);
    }
    /// For a constant factor that makes no NaN: finite in this type, and not 0.
    static std::optional<Interval<Real>> scaled(In a, In factor) {
        if (!factor.facts.constant) return std::nullopt;
        const Interval<double>& c = *factor.facts.constant;
        const Format& format = format_of(range(a).hi);
        const bool exact = factor.facts.exact() && representable(c.hi, format);
        if (exact && c.hi != 0) return scale(range(a), c.hi);
        const double smallest = format.smallest_normal;
        if (-c.neg_lo >= smallest && c.hi <= format.largest_finite) {
            return scale(range(a), range(factor), a.facts.nonnegative);
        }
        if (-c.hi >= smallest && c.neg_lo <= format.largest_finite) {
            return -scale(range(a), -range(factor), a.facts.nonnegative);
        }
        return std::nullopt;
    }

    SwitchPort<Real> switches_;
};

}  // namespace zeroset
