#pragma once

#include "engine/algebra/operand.hpp"
#include "engine/num/dual.hpp"
#include "engine/num/fold.hpp"
#include "engine/num/log_sum.hpp"
#include "engine/num/smooth_min.hpp"
#include "engine/real/field.hpp"

#include <array>

namespace zeroset {

/// Value and gradient at a point; NaN where the formula is undefined, but for operands that min
/// and max do not take.
template <class Real>
class DualAlgebra {
public:
    using Value = Dual<Real>;
    using In = const Operand<Value>&;

    Value negate(In a) { return -a.value; }
    Value add(In a, In b) { return a.value + b.value; }
    Value subtract(In a, In b) { return a.value - b.value; }
    Value multiply(In a, In b) { return a.value * b.value; }
    Value divide(In a, In b) { return a.value / b.value; }
    Value int_power(In a, int n) { return power(a.value, n); }
    Value odd_root(In a, int n) { return zeroset::odd_root(a.value, n); }
    Value sqrt(In a) { return zeroset::sqrt(a.value); }
    Value abs(In a) { return zeroset::abs(a.value); }
    Value fold(In a) { return zeroset::fold(a.value); }
    Value sign(In a) { return step(sign_of(a.value.value)); }
    Value floor(In a) { return step(round_down(a.value.value)); }
    Value ceil(In a) { return step(-round_down(-a.value.value)); }
    Value round(In a) { return step(nearest_integer(a.value.value)); }
    Value mod(In a, In b) { return zeroset::mod(a.value, b.value); }
    Value min(In a, In b) { return zeroset::min(a.value, b.value); }
    Value max(In a, In b) { return zeroset::max(a.value, b.value); }

    Value exp(In a) { return zeroset::exp(a.value); }
    Value log(In a) { return zeroset::log(a.value); }
    Value log10(In a) { return zeroset::log10(a.value); }
    Value log2(In a) { return zeroset::log2(a.value); }
    Value sin(In a) { return zeroset::sin(a.value); }
    Value cos(In a) { return zeroset::cos(a.value); }
    Value tan(In a) { return zeroset::tan(a.value); }
    Value cot(In a) { return zeroset::cot(a.value); }
    Value asin(In a) { return zeroset::asin(a.value); }
    Value acos(In a) { return zeroset::acos(a.value); }
    Value atan(In a) { return zeroset::atan(a.value); }
    Value atan2(In y, In x) { return zeroset::atan2(y.value, x.value); }
    Value angle(In y, In x) { return zeroset::atan2(y.value, x.value); }
    Value angle_sin(In y, In x, int n) { return zeroset::angle_sin(y.value, x.value, n); }
    Value angle_cos(In y, In x, int n) { return zeroset::angle_cos(y.value, x.value, n); }
    Value length(In y, In x) { return zeroset::length(y.value, x.value); }
    Value sinc(In a) { return cardinal(Cardinal::Sin, a.value); }
    Value sinhc(In a) { return cardinal(Cardinal::Sinh, a.value); }
    Value atanc(In a) { return cardinal(Cardinal::Atan, a.value); }
    Value log_sum(In a, In b) { return zeroset::log_sum(a.value, b.value); }
    Value smooth_min(In a, In b) { return zeroset::smooth_min(a.value, b.value); }
    Value oriented(In a, In b) { return zeroset::oriented(a.value, b.value.value); }
    Value sinh(In a) { return zeroset::sinh(a.value); }
    Value cosh(In a) { return zeroset::cosh(a.value); }
    Value tanh(In a) { return zeroset::tanh(a.value); }
    Value asinh(In a) { return zeroset::asinh(a.value); }
    Value acosh(In a) { return zeroset::acosh(a.value); }
    Value atanh(In a) { return zeroset::atanh(a.value); }

    Value less(In a, In b) {
        return condition(a.value.value < b.value.value, a.value.value, b.value.value);
    }
    Value less_equal(In a, In b) {
        return condition(a.value.value <= b.value.value, a.value.value, b.value.value);
    }
    Value logic_and(In a, In b) { return step(a.value.value * b.value.value); }
    Value logic_or(In a, In b) {
        return step(a.value.value + b.value.value - a.value.value * b.value.value);
    }
    Value logic_not(In a) { return step(like(a.value.value, 1.0) - a.value.value); }
    Value choose(In c, In a, In b) { return zeroset::choose(c.value.value, a.value, b.value); }
    Value field(In x, In y, In z, const Field& field, int derivative) {
        const auto out = answers(FieldValue(), field, derivative,
                                 std::array<Real, 3>{x.value.value, y.value.value, z.value.value});
        constexpr std::size_t slope = FieldValue::slope;
        return chain(out[FieldValue::value],
                     std::array<Real, 3>{out[slope], out[slope + 1], out[slope + 2]},
                     std::array<const Value*, 3>{&x.value, &y.value, &z.value});
    }
    Value where(In a, In c) { return zeroset::where(a.value, c.value.value); }

private:
    static Value step(const Real& value) { return {value, {}}; }
    static Value condition(const auto& holds, const Real& a, const Real& b) {
        const Real truth = select(holds, like(a, 1.0), like(a, 0.0));
        return step(select(unordered(a, b), like(a, not_a_number), truth));
    }
};

}  // namespace zeroset
