#pragma once

#include "engine/algebra/beam_rules.hpp"
#include "engine/num/beam_functions.hpp"
#include "engine/num/cardinal.hpp"
#include "engine/num/odd_root.hpp"

namespace zeroset {

/// Operators of BeamAlgebra that are smooth functions of one operand.
template <class Real>
class BeamElementary : public BeamRules<Real> {
protected:
    using Rules = BeamRules<Real>;
    using Rules::box;
    using Rules::curved;
    using Rules::format;
    using Rules::middle;
    using Rules::number;
    using Rules::of;
    using Rules::one;
    using Rules::smooth;
    using Rules::square_of;
    using typename Rules::Box;

public:
    using typename Rules::In;
    using typename Rules::Value;

    Value odd_root(In a, int n) {
        const auto slope = [n](const Box& x, const Box& g) { return g / zeroset::scale(x, n); };
        const auto bend = [n](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return -(zeroset::scale(slope_of_x, n - 1) / zeroset::scale(x, n));
        };
        const Box at = zeroset::odd_root(middle(a), n);
        return smooth(a, {zeroset::odd_root(box(a), n)}, at, 16.0, slope, bend);
    }
    Value sqrt(In a) {
        const Box x = box(a);
        const Enclosure<Real> root = zeroset::sqrt(x);
        const auto slope_of = [&](const Box& g) { return point(number(a, 0.5)) / g; };
        const Box slope = slope_of(root.range);
        const Box bend = zeroset::scale(power_nonnegative(slope, 3), -2.0);
        const Box at = square_root(middle(a));
        const FunctionBounds<Real> g{.range = root.range,
                                     .slope = slope,
                                     .curvature = bend,
                                     .at_middle = at,
                                     .slope_at_middle = slope_of(at),
                                     .rounding_ulp = 1.0};
        return of(zeroset::sqrt(a.value.f, g, x), slope_of_curve(a.value.f, g), root, a);
    }
    Value exp(In a) {
        const auto slope = [](const Box& /*x*/, const Box& g) { return g; };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& /*slope*/) { return g; };
        return smooth(a, {zeroset::exp(box(a))}, zeroset::exp(middle(a)), 2.0, slope, bend);
    }
    Value log(In a) { return logarithm(a, Elementary::Log, 1.0, 1.0); }
    Value log10(In a) {
        return logarithm(a, Elementary::Log10, format(a).per_ln10, 1.0 - format(a).relative_gap);
    }
    Value log2(In a) {
        return logarithm(a, Elementary::Log2, format(a).per_ln2, 1.0 - format(a).relative_gap);
    }
    Value sin(In a) { return curved(wave_over(a.value.f, sin_at(a.value.f.f.c)), {}, a); }
    Value cos(In a) { return curved(wave_over(a.value.f, cos_at(a.value.f.f.c)), {}, a); }
    Value tan(In a) {
        const auto slope = [&](const Box& /*x*/, const Box& g) { return one(a) + square_of(g); };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& slope_of_x) {
            return zeroset::scale(multiply_nonnegative_by(slope_of_x, g), 2.0);
        };
        const Box at = zeroset::tan(middle(a)).range;
        return smooth(a, zeroset::tan(box(a)), at, 4.0, slope, bend);
    }
    Value cot(In a) {
        const auto slope = [&](const Box& /*x*/, const Box& g) { return -(one(a) + square_of(g)); };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& slope_of_x) {
            return zeroset::scale(multiply_nonnegative_by(-slope_of_x, g), 2.0);
        };
        const Box at = zeroset::cot(middle(a)).range;
        return smooth(a, zeroset::cot(box(a)), at, 8.0, slope, bend);
    }
    Value asin(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) { return arc_slope(a, x); };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return multiply_nonnegative_by(power_nonnegative(slope_of_x, 3), x);
        };
        const Box at = zeroset::asin(middle(a)).range;
        return smooth(a, zeroset::asin(box(a)), at, 4.0, slope, bend);
    }
    Value acos(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) { return -arc_slope(a, x); };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return -multiply_nonnegative_by(power_nonnegative(-slope_of_x, 3), x);
        };
        const Box at = zeroset::acos(middle(a)).range;
        return smooth(a, zeroset::acos(box(a)), at, 4.0, slope, bend);
    }
    Value atan(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return one(a) / (one(a) + square_of(x));
        };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return zeroset::scale(multiply_nonnegative_by(power_nonnegative(slope_of_x, 2), x),
                                  -2.0);
        };
        return smooth(a, {zeroset::atan(box(a))}, zeroset::atan(middle(a)), 4.0, slope, bend);
    }
    Value sinc(In a) { return cardinal_form(a, Cardinal::Sin); }
    Value sinhc(In a) { return cardinal_form(a, Cardinal::Sinh); }
    Value atanc(In a) { return cardinal_form(a, Cardinal::Atan); }
    Value sinh(In a) {
        const auto slope = [](const Box& x, const Box& /*g*/) { return zeroset::cosh(x); };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& /*slope*/) { return g; };
        const Box at = odd_increasing(Elementary::Sinh, middle(a));
        return smooth(a, {odd_increasing(Elementary::Sinh, box(a))}, at, 4.0, slope, bend);
    }
    Value cosh(In a) {
        const auto slope = [](const Box& x, const Box& /*g*/) {
            return odd_increasing(Elementary::Sinh, x);
        };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& /*slope*/) { return g; };
        return smooth(a, {zeroset::cosh(box(a))}, zeroset::cosh(middle(a)), 4.0, slope, bend);
    }
    Value tanh(In a) {
        const auto slope = [&](const Box& /*x*/, const Box& g) { return one(a) - square_of(g); };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& slope_of_x) {
            return zeroset::scale(slope_of_x * g, -2.0);
        };
        return smooth(a, {zeroset::tanh(box(a))}, zeroset::tanh(middle(a)), 4.0, slope, bend);
    }
    Value asinh(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return one(a) / square_root(one(a) + square_of(x));
        };
        const Box at = odd_increasing(Elementary::Asinh, middle(a));
        return smooth(a, {odd_increasing(Elementary::Asinh, box(a))}, at, 2.0, slope, area_bend);
    }
    Value acosh(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return one(a) / square_root(square_of(x) - one(a));
        };
        const Box at = zeroset::acosh(middle(a)).range;
        return smooth(a, zeroset::acosh(box(a)), at, 2.0, slope, area_bend);
    }
    Value atanh(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return one(a) / (one(a) - square_of(x));
        };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return zeroset::scale(x * power(slope_of_x, 2, false), 2.0);
        };
        const Box at = zeroset::atanh(middle(a)).range;
        return smooth(a, zeroset::atanh(box(a)), at, 2.0, slope, bend);
    }

private:
    /// The bend of asinh and acosh.
    static Box area_bend(const Box& x, const Box& /*g*/, const Box& slope) {
        return -multiply_nonnegative_by(power_nonnegative(slope, 3), x);
    }
    /// log a times `scale`, which is known but for a factor from `least` to 1 / `least`.
    Value logarithm(In a, Elementary function, double scale, double least) {
        const Enclosure<Real> range = zeroset::logarithm(function, box(a));
        const Box factor{number(a, -scale * least), number(a, scale * (2.0 - least))};
        const auto slope = [&](const Box& x, const Box& /*g*/) { return factor / x; };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return -(slope_of_x / x);
        };
        return smooth(a, range, zeroset::logarithm(function, middle(a)).range, 4.0, slope, bend);
    }
    static Value cardinal_form(In a, Cardinal function) {
        const auto slope = [&](const Box& x, const Box& g) {
            return cardinal_slope(function, x, g);
        };
        const auto bend = [&](const Box& x, const Box& g, const Box& slope_of_x) {
            return cardinal_bend(function, x, g, slope_of_x);
        };
        const Box g = cardinal(function, a.value.f.range());
        return smooth(a, {g}, cardinal(function, middle(a)), cardinal_error_ulp, slope, bend);
    }
    /// 1 / sqrt(1 - x^2)
    static Box arc_slope(In a, const Box& x) {
        return one(a) / square_root((one(a) - x) * (one(a) + x));
    }
};

}  // namespace zeroset
