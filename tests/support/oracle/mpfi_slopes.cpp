#include "tests/support/oracle/mpfi_field.hpp"
#include "tests/support/oracle/mpfi_operators.hpp"

#include <utility>

// Slopes between any two points of a line, by the mean value theorem with g' over the operands'
// ranges.

namespace zeroset::test {
namespace {

using Mpfi = MpfiInterval;

Mpfi square(const Mpfi& a) { return power(a, 2); }
/// The square root of a number that cannot be negative.
Mpfi root(const Mpfi& a) { return computed(mpfi_sqrt, maximum(a, Mpfi(0.0))); }
Mpfi one_over(const Mpfi& a) { return Mpfi(1.0) / a; }
Mpfi logarithm_of(double a) { return computed(mpfi_log, Mpfi(a)); }
Mpfi range_of(Op op, const Mpfi& a) { return enclosed({.op = op}, {a}, {a}, {a}).range; }

/// The slope of a choice: of the first or second function where that is taken on the whole box.
Mpfi slope_of_choice(bool first, bool second, const Mpfi& a, const Mpfi& b) {
    if (first) return a;
    return second ? b : hull(a, b);
}

Mpfi slope_of_power(const Mpfi& a, int n) {
    return Mpfi(n) * (n > 0 ? power(a, n - 1) : one_over(power(a, 1 - n)));
}

/// The slope of the angle of the point (b, a).
Mpfi slope_of_angle(const MpfiDual& a, const MpfiDual& b) {
    const Mpfi& y = a.value.range;
    const Mpfi& x = b.value.range;
    return (a.slope * x - y * b.slope) / (square(x) + square(y));
}
Mpfi wave_of(Op op, const Node& node, const MpfiDual& a, const MpfiDual& b) {
    return enclosed({.op = op, .number = node.number}, a.value, b.value, b.value).range;
}

/// The slope of f(x)/x, whose size is at most `bend` times |x|; `df` is the slope of f.
Mpfi slope_by_itself(const Mpfi& x, const Mpfi& value, const Mpfi& df, double bend) {
    if (x.contains_zero()) return x * Mpfi(-bend, bend);
    return (df - value) / x;
}

}  // namespace

MpfiDual dual(MpfiInterval range, MpfiInterval slope) {
    MpfiDual result;
    result.value.range = std::move(range);
    result.slope = std::move(slope);
    return result;
}

// NOLINTNEXTLINE(readability-function-size): one switch over all operators
MpfiInterval slope_of(const Node& node, const MpfiEnclosure& value, const MpfiDual& a,
                      const MpfiDual& b, const MpfiDual& c) {
    const Mpfi one(1.0);
    const Mpfi& f = value.range;
    const Mpfi& x = a.value.range;
    const Mpfi& y = b.value.range;
    const bool below = mpfr_lessequal_p(x.hi(), y.lo()) != 0;
    const bool above = mpfr_lessequal_p(y.hi(), x.lo()) != 0;
    switch (node.op) {
        case Op::Constant:
        case Op::Variable: break;
        case Op::Negate: return -a.slope;
        case Op::Add: return a.slope + b.slope;
        case Op::Subtract: return a.slope - b.slope;
        case Op::Multiply: return a.slope * y + x * b.slope;
        case Op::Divide: return (a.slope - f * b.slope) / y;
        case Op::IntPower: return slope_of_power(x, node.number) * a.slope;
        case Op::OddRoot: return f / (Mpfi(node.number) * x) * a.slope;
        case Op::Sqrt: return one_over(Mpfi(2.0) * f) * a.slope;
        case Op::Abs: return slope_of_choice(x.is_above(0), x.is_below(0), a.slope, -a.slope);
        case Op::Min: return slope_of_choice(below, above, a.slope, b.slope);
        case Op::Max: return slope_of_choice(above, below, a.slope, b.slope);
        case Op::Sign:
        case Op::Floor:
        case Op::Ceil:
        case Op::Round:
        case Op::Less:
        case Op::LessEqual:
        case Op::And:
        case Op::Or:
        case Op::Not: return Mpfi(0.0);
        case Op::Mod: return a.slope - b.slope * range_of(Op::Floor, x / y);
        case Op::Exp: return f * a.slope;
        case Op::Log: return one_over(x) * a.slope;
        case Op::Log10: return one_over(x * logarithm_of(10)) * a.slope;
        case Op::Log2: return one_over(x * logarithm_of(2)) * a.slope;
        case Op::Sin: return range_of(Op::Cos, x) * a.slope;
        case Op::Cos: return -range_of(Op::Sin, x) * a.slope;
        case Op::Tan: return (one + square(f)) * a.slope;
        case Op::Cot: return -(one + square(f)) * a.slope;
        case Op::Asin: return one_over(root(one - square(x))) * a.slope;
        case Op::Acos: return -one_over(root(one - square(x))) * a.slope;
        case Op::Atan: return one_over(one + square(x)) * a.slope;
        case Op::Atan2:
        case Op::Angle: return slope_of_angle(a, b);
        case Op::AngleSin:
            return wave_of(Op::AngleCos, node, a, b) * slope_of_angle(a, b) * Mpfi(node.number);
        case Op::AngleCos:
            return -wave_of(Op::AngleSin, node, a, b) * slope_of_angle(a, b) * Mpfi(node.number);
        case Op::Length: return (x * a.slope + y * b.slope) / f;
        case Op::Sinc: return slope_by_itself(x, f, range_of(Op::Cos, x), 0.34) * a.slope;
        case Op::Sinhc: {
            const Mpfi df = range_of(Op::Cosh, x);
            return slope_by_itself(x, f, df, 0.34 * mpfr_get_d(df.hi(), MPFR_RNDU)) * a.slope;
        }
        case Op::Atanc: return slope_by_itself(x, f, one_over(one + square(x)), 0.67) * a.slope;
        case Op::Fold: return hull(a.slope, -a.slope);
        case Op::LogSum: {
            const Mpfi share_of_a = one_over(one + range_of(Op::Exp, y - x));
            return share_of_a * a.slope + (one - share_of_a) * b.slope;
        }
        case Op::SmoothMin: {
            const Mpfi share_of_a = minimum(maximum((one - (x - y)) / Mpfi(2.0), Mpfi(0.0)), one);
            return share_of_a * a.slope + (one - share_of_a) * b.slope;
        }
        case Op::Oriented: return slope_of_choice(y.is_above(0), y.is_below(0), a.slope, -a.slope);
        case Op::Sinh: return range_of(Op::Cosh, x) * a.slope;
        case Op::Cosh: return range_of(Op::Sinh, x) * a.slope;
        case Op::Tanh: return (one - square(f)) * a.slope;
        case Op::Asinh: return one_over(root(one + square(x))) * a.slope;
        case Op::Acosh: return one_over(root(square(x) - one)) * a.slope;
        case Op::Atanh: return one_over(one - square(x)) * a.slope;
        case Op::If: return slope_of_choice(x.is_above(0), x.is_below(0), b.slope, c.slope);
        case Op::Where: return a.slope;
        case Op::Field: return slope_of_field(*node.field, a, b, c);
    }
    return Mpfi::whole_line();
}

}  // namespace zeroset::test
