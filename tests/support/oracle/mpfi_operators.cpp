#include "tests/support/oracle/mpfi_operators.hpp"

#include "tests/support/oracle/mpfi_field.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace zeroset::test {
namespace {

using Mpfi = MpfiInterval;
using In = const MpfiEnclosure&;

MpfiEnclosure nowhere() { return {Mpfi::whole_line(), false, false, false}; }

/// The enclosure of g(operands...): as defined and continuous as g and its operands are.
template <class... Operands>
MpfiEnclosure composed(MpfiEnclosure g, const Operands&... operands) {
    if (!(g.somewhere && ... && operands.somewhere)) return nowhere();
    g.everywhere = (g.everywhere && ... && operands.everywhere);
    g.continuous = (g.continuous && ... && operands.continuous);
    return g;
}

template <class... Operands>
MpfiEnclosure total(Mpfi range, const Operands&... operands) {
    return composed(MpfiEnclosure{std::move(range)}, operands...);
}

/// Whether the interval holds numbers for which periodic functions would need gigabytes of pi.
bool out_of_reach(const Mpfi& a) {
    constexpr mpfr_exp_t limit = 5000;
    const auto beyond = [](mpfr_srcptr end) {
        if (mpfr_zero_p(end) != 0) return false;
        if (mpfr_regular_p(end) == 0) return true;
        return mpfr_get_exp(end) > limit || mpfr_get_exp(end) < -limit;
    };
    return beyond(a.lo()) || beyond(a.hi());
}

/// A function that is defined on [lo, hi] only.
MpfiEnclosure on_domain(MpfiFunction1 function, In a, double lo, double hi) {
    if (a.range.is_above(hi) || a.range.is_below(lo)) return nowhere();
    const Mpfi domain(lo, hi);
    MpfiEnclosure g{a.range};
    g.everywhere = mpfi_is_inside(a.range.get(), domain.get()) != 0;
    if (!g.everywhere) mpfi_intersect(g.range.get(), a.range.get(), domain.get());
    g.range = computed(function, g.range);
    return composed(g, a);
}

/// A function that is defined on (lo, hi) only.
MpfiEnclosure within(MpfiFunction1 function, In a, double lo, double hi) {
    if (mpfr_cmp_d(a.range.lo(), hi) >= 0 || mpfr_cmp_d(a.range.hi(), lo) <= 0) return nowhere();
    MpfiEnclosure g = on_domain(function, a, lo, hi);
    g.everywhere = g.everywhere && a.range.is_above(lo) && a.range.is_below(hi);
    return g;
}

MpfiEnclosure logarithm(MpfiFunction1 function, In a) {
    return within(function, a, 0, std::numeric_limits<double>::infinity());
}

MpfiEnclosure wave(MpfiFunction1 function, In a) {
    return total(out_of_reach(a.range) ? Mpfi(-1, 1) : computed(function, a.range), a);
}

/// tan or cot: unbounded where a pole is met.
MpfiEnclosure with_poles(MpfiFunction1 function, In a) {
    MpfiEnclosure g{out_of_reach(a.range) ? Mpfi::whole_line() : computed(function, a.range)};
    g.everywhere = g.continuous = g.range.is_bounded();
    return composed(g, a);
}

/// A function whose values are integers: continuous where there is only one of them.
MpfiEnclosure stepped(Mpfi range, In a) {
    MpfiEnclosure g{std::move(range)};
    g.continuous = g.range.is_point();
    return composed(g, a);
}

Mpfi sign_of(const Mpfi& a) {
    const auto sign = [](mpfr_srcptr end) { return static_cast<double>(mpfr_sgn(end)); };
    return {sign(a.lo()), sign(a.hi())};
}

Mpfi floor_of(const Mpfi& a) {
    return increasing([](mpfr_ptr out, mpfr_srcptr in, mpfr_rnd_t) { return mpfr_floor(out, in); },
                      a);
}

MpfiEnclosure quotient(In a, In b) {
    if (b.range.is_zero()) return nowhere();
    MpfiEnclosure g{a.range / b.range};
    g.everywhere = g.continuous = !b.range.contains_zero();
    return composed(g, a, b);
}

MpfiEnclosure oriented(In a, In b) {
    if (b.range.is_zero()) return nowhere();
    const bool below = b.range.is_below(0);
    MpfiEnclosure g{below ? -a.range : a.range};
    g.everywhere = g.continuous = below || b.range.is_above(0);
    if (!g.everywhere) g.range = hull(a.range, -a.range);
    return composed(g, a, b);
}

/// a - b floor(a/b): between 0 and b.
MpfiEnclosure modulo(In a, In b) {
    if (b.range.is_zero()) return nowhere();
    MpfiEnclosure g{hull(Mpfi(0.0), b.range)};
    g.everywhere = !b.range.contains_zero();
    g.continuous = false;
    if (g.everywhere && !out_of_reach(a.range) && !out_of_reach(b.range)) {
        const Mpfi turns = floor_of(a.range / b.range);
        g.continuous = turns.is_point();
        if (g.continuous) {
            const Mpfi rest = a.range - b.range * turns;
            mpfi_intersect(g.range.get(), g.range.get(), rest.get());
        }
    }
    return composed(g, a, b);
}

Mpfi circle() { return hull(-Mpfi::pi(), Mpfi::pi()); }

/// The angle of (x, y). `counts_turns`: atan2, which jumps at its cut; else the value is known only
/// up to a multiple of 2 pi.
MpfiEnclosure angle(In y, In x, bool counts_turns) {
    const bool crosses_axis = y.range.contains_zero();
    if (y.range.is_zero() && x.range.is_zero()) return nowhere();
    if (crosses_axis && x.range.contains_zero()) {
        return composed(MpfiEnclosure{circle(), true, false, false}, y, x);
    }
    const bool cut = crosses_axis && x.range.is_below(0);
    const bool far = out_of_reach(y.range) || out_of_reach(x.range);
    if (far || (cut && counts_turns)) {
        return composed(MpfiEnclosure{circle(), true, true, false}, y, x);
    }
    if (cut) return total(computed(mpfi_atan2, -y.range, -x.range) + Mpfi::pi(), y, x);
    return total(computed(mpfi_atan2, y.range, x.range), y, x);
}

/// A sine or cosine of n times the angle.
MpfiEnclosure angle_wave(MpfiFunction1 function, int n, In y, In x) {
    MpfiEnclosure turn = angle(y, x, false);
    turn.range = Mpfi(n) * turn.range;
    return wave(function, turn);
}

/// function(a) / a, which is 1 at 0.
Mpfi by_itself(MpfiFunction1 function, const Mpfi& a) {
    return a.is_zero() ? Mpfi(1.0) : computed(function, a) / a;
}

Mpfi point_of(mpfr_srcptr end) {
    Mpfi result;
    mpfi_set_fr(result.get(), end);
    return result;
}

/// sinh(a)/a and atan(a)/a, which are monotone in |a|.
MpfiEnclosure cardinal(MpfiFunction1 function, In a) {
    const Mpfi size = computed(mpfi_abs, a.range);
    if (!size.is_bounded() || out_of_reach(size)) {
        return total(Mpfi(0, std::numeric_limits<double>::infinity()), a);
    }
    const Mpfi near = by_itself(function, point_of(size.lo()));
    return total(hull(near, by_itself(function, point_of(size.hi()))), a);
}

/// sin(a)/a, which falls up to |a| = 3 and stays within 0.22 from there on.
MpfiEnclosure cardinal_sine(In a) {
    const Mpfi size = computed(mpfi_abs, a.range);
    if (size.is_below(3)) return cardinal(mpfi_sin, a);
    const Mpfi beyond(-0.22, 0.22);
    if (!size.is_above(3)) return total(hull(Mpfi(1.0), beyond), a);
    const bool is_known = size.is_bounded() && !out_of_reach(size);
    return total(is_known ? computed(mpfi_sin, size) / size : beyond, a);
}

/// The distance from the nearest even integer: either the one below the lower end or the next one.
MpfiEnclosure fold(In a) {
    const Mpfi all = hull(Mpfi(0.0), Mpfi(1.0));
    if (!a.range.is_bounded()) return total(all, a);
    const Mpfi turns = a.range * Mpfi(0.5);
    const Mpfi below = Mpfi(2.0) * floor_of(point_of(turns.lo()));
    const Mpfi v = a.range - below;
    if (!v.is_below(3)) return total(all, a);
    const Mpfi distance = minimum(computed(mpfi_abs, v), computed(mpfi_abs, v - Mpfi(2.0)));
    return total(minimum(distance, Mpfi(1.0)), a);
}

/// ln(e^a + e^b), which increases with both operands.
MpfiEnclosure log_sum(In a, In b) {
    if (!a.range.is_bounded() || !b.range.is_bounded()) return total(Mpfi::whole_line(), a, b);
    const auto at = [](const Mpfi& p, const Mpfi& q) {
        const Mpfi distance = computed(mpfi_abs, p - q);
        return maximum(p, q) + computed(mpfi_log1p, computed(mpfi_exp, -distance));
    };
    return total(hull(at(point_of(a.range.lo()), point_of(b.range.lo())),
                      at(point_of(a.range.hi()), point_of(b.range.hi()))),
                 a, b);
}

/// min(a, b) - h^2/4 with h = max(1 - |a - b|, 0), which increases with both operands.
MpfiEnclosure smooth_min(In a, In b) {
    if (!a.range.is_bounded() || !b.range.is_bounded()) return total(Mpfi::whole_line(), a, b);
    const auto at = [](const Mpfi& p, const Mpfi& q) {
        const Mpfi height = maximum(Mpfi(1.0) - computed(mpfi_abs, p - q), Mpfi(0.0));
        return minimum(p, q) - power(height, 2) / Mpfi(4.0);
    };
    return total(hull(at(point_of(a.range.lo()), point_of(b.range.lo())),
                      at(point_of(a.range.hi()), point_of(b.range.hi()))),
                 a, b);
}

/// A condition that surely holds, surely fails, or is open; decided, it is continuous whatever its
/// operands are.
template <class... Operands>
MpfiEnclosure condition(bool holds, bool fails, const Operands&... operands) {
    MpfiEnclosure g = total(Mpfi(holds ? 1 : 0, fails ? 0 : 1), operands...);
    g.continuous = g.somewhere && (holds || fails);
    return g;
}

bool surely_holds(In a) { return a.range.is_above(0); }
bool surely_fails(In a) { return mpfr_sgn(a.range.hi()) <= 0; }

MpfiEnclosure less(In a, In b) {
    return condition(mpfr_less_p(a.range.hi(), b.range.lo()) != 0,
                     mpfr_greaterequal_p(a.range.lo(), b.range.hi()) != 0, a, b);
}
MpfiEnclosure less_equal(In a, In b) {
    return condition(mpfr_lessequal_p(a.range.hi(), b.range.lo()) != 0,
                     mpfr_greater_p(a.range.lo(), b.range.hi()) != 0, a, b);
}

MpfiEnclosure choose(In c, In a, In b) {
    if (!c.somewhere) return nowhere();
    MpfiEnclosure g;
    if (surely_holds(c)) {
        g = a;
    } else if (surely_fails(c)) {
        g = b;
    } else if (!a.somewhere || !b.somewhere) {
        g = a.somewhere ? a : b;
        g.everywhere = g.continuous = false;
    } else {
        g = {hull(a.range, b.range), true, a.everywhere && b.everywhere, false};
    }
    g.everywhere = g.everywhere && c.everywhere;
    return g;
}

MpfiEnclosure where(In a, In c) {
    if (!c.somewhere || surely_fails(c)) return nowhere();
    MpfiEnclosure g = a;
    g.everywhere = a.everywhere && c.everywhere && surely_holds(c);
    return g;
}

Mpfi integer_power(const Mpfi& a, int n) { return n >= 0 ? power(a, n) : Mpfi(1.0) / power(a, -n); }

}  // namespace

// NOLINTNEXTLINE(readability-function-size): one switch over all operators
MpfiEnclosure enclosed(const Node& node, In a, In b, In c) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    switch (node.op) {
        case Op::Constant:
        case Op::Variable: break;
        case Op::Negate: return total(-a.range, a);
        case Op::Add: return total(a.range + b.range, a, b);
        case Op::Subtract: return total(a.range - b.range, a, b);
        case Op::Multiply: return total(a.range * b.range, a, b);
        case Op::Divide: return quotient(a, b);
        case Op::IntPower: return total(integer_power(a.range, node.number), a);
        case Op::OddRoot: return total(odd_root(a.range, node.number), a);
        case Op::Sqrt: return on_domain(mpfi_sqrt, a, 0, infinity);
        case Op::Abs: return total(computed(mpfi_abs, a.range), a);
        case Op::Sign: return stepped(sign_of(a.range), a);
        case Op::Floor: return stepped(floor_of(a.range), a);
        case Op::Ceil: return stepped(-floor_of(-a.range), a);
        case Op::Round: return stepped(floor_of(a.range + Mpfi(0.5)), a);
        case Op::Mod: return modulo(a, b);
        case Op::Min: return total(minimum(a.range, b.range), a, b);
        case Op::Max: return total(maximum(a.range, b.range), a, b);
        case Op::Exp: return total(computed(mpfi_exp, a.range), a);
        case Op::Log: return logarithm(mpfi_log, a);
        case Op::Log10: return logarithm(mpfi_log10, a);
        case Op::Log2: return logarithm(mpfi_log2, a);
        case Op::Sin: return wave(mpfi_sin, a);
        case Op::Cos: return wave(mpfi_cos, a);
        case Op::Tan: return with_poles(mpfi_tan, a);
        case Op::Cot: return a.range.is_zero() ? nowhere() : with_poles(mpfi_cot, a);
        case Op::Asin: return on_domain(mpfi_asin, a, -1, 1);
        case Op::Acos: return on_domain(mpfi_acos, a, -1, 1);
        case Op::Atan: return total(computed(mpfi_atan, a.range), a);
        case Op::Atan2: return angle(a, b, true);
        case Op::Angle: return angle(a, b, false);
        case Op::AngleSin: return angle_wave(mpfi_sin, node.number, a, b);
        case Op::AngleCos: return angle_wave(mpfi_cos, node.number, a, b);
        case Op::Length: return total(computed(mpfi_hypot, a.range, b.range), a, b);
        case Op::Sinc: return cardinal_sine(a);
        case Op::Sinhc: return cardinal(mpfi_sinh, a);
        case Op::Atanc: return cardinal(mpfi_atan, a);
        case Op::Fold: return fold(a);
        case Op::LogSum: return log_sum(a, b);
        case Op::SmoothMin: return smooth_min(a, b);
        case Op::Oriented: return oriented(a, b);
        case Op::Sinh: return total(computed(mpfi_sinh, a.range), a);
        case Op::Cosh: return total(computed(mpfi_cosh, a.range), a);
        case Op::Tanh: return total(computed(mpfi_tanh, a.range), a);
        case Op::Asinh: return total(computed(mpfi_asinh, a.range), a);
        case Op::Acosh: return on_domain(mpfi_acosh, a, 1, infinity);
        case Op::Atanh: return within(mpfi_atanh, a, -1, 1);
        case Op::Less: return less(a, b);
        case Op::LessEqual: return less_equal(a, b);
        case Op::And:
            return condition(surely_holds(a) && surely_holds(b), surely_fails(a) || surely_fails(b),
                             a, b);
        case Op::Or:
            return condition(surely_holds(a) || surely_holds(b), surely_fails(a) && surely_fails(b),
                             a, b);
        case Op::Not: return condition(surely_fails(a), surely_holds(a), a);
        case Op::If: return choose(a, b, c);
        case Op::Where: return where(a, b);
        case Op::Field: return enclosed_field(*node.field, a, b, c);
    }
    ADD_FAILURE() << "the oracle does not know operator " << static_cast<int>(node.op);
    return nowhere();
}

}  // namespace zeroset::test
