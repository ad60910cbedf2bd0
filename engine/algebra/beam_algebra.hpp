#pragma once

#include "engine/algebra/interval_algebra.hpp"
#include "engine/num/beam_angle.hpp"
#include "engine/num/beam_log_sum.hpp"
#include "engine/num/beam_polar.hpp"
#include "engine/num/beam_smooth_min.hpp"
#include "engine/num/fold.hpp"

#include <optional>

namespace zeroset {

/// f over a cell with its derivative along the ray, and what is known of the domain. An absent
/// derivative is 0, an absent mask true.
template <class Real>
struct BeamValue {
    using Mask = typename Enclosure<Real>::Mask;

    Beam<Real> f;
    /// Where f is continuous it is piecewise smooth; encloses the slopes of the pieces.
    std::optional<SlopeBeam<Real>> slope{};
    std::optional<Mask> somewhere{};  ///< as in Enclosure
    std::optional<Mask> everywhere{};
    std::optional<Mask> continuous{};
    /// Vanishes wherever f does, and is f where f is continuous; absent: f. Only the root's counts.
    std::optional<Beam<Real>> zeros{};
};

/// Beam forms of value and derivative, over any carrier, in upward rounding.
template <class Real>
class BeamAlgebra {
public:
    using Value = BeamValue<Real>;
    using In = const Operand<Value>&;
    using Form = Beam<Real>;
    using Mask = typename Value::Mask;
    using Box = Interval<Real>;
    using Slope = std::optional<SlopeBeam<Real>>;

    BeamAlgebra() = default;
    explicit BeamAlgebra(SwitchBoard<Real>* board) : switches_(board) {}

    /// The next operator is this switch, or none.
    void enter(SwitchIndex index) { switches_.enter(index); }

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
        const auto slope_of = [&](const Box& g) { return point(number(0.5)) / g; };
        const Box slope = slope_of(root.range);
        const Box bend = zeroset::scale(power_nonnegative(slope, 3), -2.0);
        const Box at = square_root(middle(a));
        const FunctionBounds<Real> g{root.range, slope, bend, at, slope_of(at), 1.0};
        return of(zeroset::sqrt(a.value.f, g, x), slope_of_curve(a.value.f, g), root, a);
    }
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
    Value fold(In a);
    Value sign(In a) {
        const Box signs = zeroset::sign_steps(box(a));
        return jump(signs, a, number(0));
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
        return jump(integers, a, integers.hi - number(0.5));
    }
    Value mod(In a, In b);
    Value min(In a, In b) { return larger(a, b, -1.0); }
    Value max(In a, In b) { return larger(a, b, 1.0); }

    Value exp(In a) {
        const auto slope = [](const Box& /*x*/, const Box& g) { return g; };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& /*slope*/) { return g; };
        return smooth(a, {zeroset::exp(box(a))}, zeroset::exp(middle(a)), 2.0, slope, bend);
    }
    Value log(In a) { return logarithm(a, Elementary::Log, 1.0, 1.0); }
    Value log10(In a) {
        kind_ = &a.value.f.r;
        return logarithm(a, Elementary::Log10, format().per_ln10, 1.0 - format().relative_gap);
    }
    Value log2(In a) {
        kind_ = &a.value.f.r;
        return logarithm(a, Elementary::Log2, format().per_ln2, 1.0 - format().relative_gap);
    }
    Value sin(In a) { return curved(wave_over(a.value.f, sin_at(a.value.f.f.c)), {}, a); }
    Value cos(In a) { return curved(wave_over(a.value.f, cos_at(a.value.f.f.c)), {}, a); }
    Value tan(In a) {
        const auto slope = [&](const Box& /*x*/, const Box& g) { return one() + square_of(g); };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& slope_of_x) {
            return zeroset::scale(multiply_nonnegative_by(slope_of_x, g), 2.0);
        };
        const Box at = zeroset::tan(middle(a)).range;
        return smooth(a, zeroset::tan(box(a)), at, 4.0, slope, bend);
    }
    Value cot(In a) {
        const auto slope = [&](const Box& /*x*/, const Box& g) { return -(one() + square_of(g)); };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& slope_of_x) {
            return zeroset::scale(multiply_nonnegative_by(-slope_of_x, g), 2.0);
        };
        const Box at = zeroset::cot(middle(a)).range;
        return smooth(a, zeroset::cot(box(a)), at, 8.0, slope, bend);
    }
    Value asin(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) { return arc_slope(x); };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return multiply_nonnegative_by(power_nonnegative(slope_of_x, 3), x);
        };
        const Box at = zeroset::asin(middle(a)).range;
        return smooth(a, zeroset::asin(box(a)), at, 4.0, slope, bend);
    }
    Value acos(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) { return -arc_slope(x); };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return -multiply_nonnegative_by(power_nonnegative(-slope_of_x, 3), x);
        };
        const Box at = zeroset::acos(middle(a)).range;
        return smooth(a, zeroset::acos(box(a)), at, 4.0, slope, bend);
    }
    Value atan(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return one() / (one() + square_of(x));
        };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return zeroset::scale(multiply_nonnegative_by(power_nonnegative(slope_of_x, 2), x),
                                  -2.0);
        };
        return smooth(a, {zeroset::atan(box(a))}, zeroset::atan(middle(a)), 4.0, slope, bend);
    }
    Value atan2(In y, In x);
    Value angle(In y, In x) {
        const Real angle = elementary(Elementary::Atan2, y.value.f.f.c, x.value.f.f.c);
        const Box at = widened(Elementary::Atan2, angle, angle);
        const auto around_origin = angle_cases(box(y), box(x)).around_origin;
        const Turn<Real> turn = this->turn(y, x);
        // A convex cell beside the origin is seen under less than a half turn.
        const Real most = number(format().pi_hi);
        const Real far = minimum(
            largest(turn.by_y) * y.value.f.spread() + largest(turn.by_x) * x.value.f.spread(),
            most);
        const Box beside = at + within<Real>(far);
        const Box range = select(around_origin, within<Real>(most), beside);
        return turning({range, {}, no(around_origin), no(around_origin)}, at, turn, y, x);
    }
    Value angle_sin(In y, In x, int n);
    Value angle_cos(In y, In x, int n);
    Value length(In y, In x);
    Value sinc(In a) { return cardinal_form(a, Cardinal::Sin); }
    Value sinhc(In a) { return cardinal_form(a, Cardinal::Sinh); }
    Value atanc(In a) { return cardinal_form(a, Cardinal::Atan); }
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
    Value smooth_min(In a, In b) {
        const Form difference = a.value.f - b.value.f;
        return blend(a, b, difference, blend_sides(difference.range()));
    }
    Value oriented(In a, In b);
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
        const auto slope = [&](const Box& /*x*/, const Box& g) { return one() - square_of(g); };
        const auto bend = [](const Box& /*x*/, const Box& g, const Box& slope_of_x) {
            return zeroset::scale(slope_of_x * g, -2.0);
        };
        return smooth(a, {zeroset::tanh(box(a))}, zeroset::tanh(middle(a)), 4.0, slope, bend);
    }
    Value asinh(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return one() / square_root(one() + square_of(x));
        };
        const Box at = odd_increasing(Elementary::Asinh, middle(a));
        return smooth(a, {odd_increasing(Elementary::Asinh, box(a))}, at, 2.0, slope, area_bend);
    }
    Value acosh(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return one() / square_root(square_of(x) - one());
        };
        const Box at = zeroset::acosh(middle(a)).range;
        return smooth(a, zeroset::acosh(box(a)), at, 2.0, slope, area_bend);
    }
    Value atanh(In a) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return one() / (one() - square_of(x));
        };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return zeroset::scale(x * power(slope_of_x, 2, false), 2.0);
        };
        const Box at = zeroset::atanh(middle(a)).range;
        return smooth(a, zeroset::atanh(box(a)), at, 2.0, slope, bend);
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
        return decided(switches_.outcomes(one() - condition), a);
    }
    Value choose(In c, In a, In b);
    Value where(In a, In c);

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
    Real number(double value) { return like(*kind_, value); }
    const Format& format() { return format_of(*kind_); }
    Box one() { return point(number(1)); }
    static Box square_of(const Box& a) { return power_nonnegative(absolute(a), 2); }

    /// The range of the form. Every operator that needs one begins with it.
    Box box(In a) {
        kind_ = &a.value.f.r;
        return a.value.f.range();
    }
    static Box middle(In a) { return point(a.value.f.f.c); }

    SlopeBeam<Real> no_slope() { return {{number(0), {}, number(0)}, number(0)}; }
    /// A slope made of those of a and b, of which an absent one is 0; absent where both are.
    Slope joined_slope(In a, In b, auto join) {
        if (!a.value.slope && !b.value.slope) return std::nullopt;
        kind_ = &a.value.f.r;
        const SlopeBeam<Real> zero = no_slope();
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
        return {f, slope, conjunction_of(operands.value.somewhere...),
                conjunction_of(operands.value.everywhere...),
                conjunction_of(operands.value.continuous...)};
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
        return curved({g.range, slopes, bends, at, slope(middle(a), at), rounding_ulp}, g, a);
    }
    /// Of asinh and acosh.
    static Box area_bend(const Box& x, const Box& /*g*/, const Box& slope) {
        return -multiply_nonnegative_by(power_nonnegative(slope, 3), x);
    }
    /// Constant where it is continuous.
    template <class... Operands>
    static Value stepped_form(const Enclosure<Real>& g, const Operands&... operands) {
        const Real nothing = like(g.range.hi, 0.0);
        return with_domain(of(interval_form(g.range, nothing), std::nullopt, operands...), g);
    }
    /// A number of these outcomes, which changes where `a` is `level`, if there are two.
    Value jump(const Box& outcomes, In a, const Real& level) {
        if (switches_.wants_cuts()) {
            tell_cut(outcomes, a.value.f - interval_form(point(level), number(0)));
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
        const Real reciprocal = number(1) / slope;
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

    /// A constant factor that is a number of the format.
    std::optional<double> exact_factor(In a) {
        kind_ = &a.value.f.r;
        if (!a.facts.exact() || !representable(a.facts.constant->hi, format())) return {};
        return a.facts.constant->hi;
    }
    static Value multiple(In a, double c) {
        const Slope slope = a.value.slope ? Slope(scale(*a.value.slope, c)) : Slope();
        return of(scale(a.value.f, c), slope, a);
    }
    /// log a times `scale`, which is known but for a factor from `least` to 1 / `least`.
    Value logarithm(In a, Elementary function, double scale, double least) {
        const Enclosure<Real> range = zeroset::logarithm(function, box(a));
        const Box factor{number(-scale * least), number(scale * (2.0 - least))};
        const auto slope = [&](const Box& x, const Box& /*g*/) { return factor / x; };
        const auto bend = [](const Box& x, const Box& /*g*/, const Box& slope_of_x) {
            return -(slope_of_x / x);
        };
        return smooth(a, range, zeroset::logarithm(function, middle(a)).range, 4.0, slope, bend);
    }
    static Value cardinal_form(In a, Cardinal function) {
        const auto slope = [&](const Box& x, const Box& /*g*/) {
            return cardinal_bends(function, x).by_x * x;
        };
        const auto bend = [&](const Box& x, const Box& /*g*/, const Box& /*slope*/) {
            return cardinal_bends(function, x).second;
        };
        const Box g = cardinal(function, a.value.f.range());
        return smooth(a, {g}, cardinal(function, middle(a)), cardinal_error_ulp, slope, bend);
    }
    /// 1 / sqrt(1 - x^2)
    Box arc_slope(const Box& x) { return one() / square_root((one() - x) * (one() + x)); }
    Turn<Real> turn(In y, In x) { return turn_of(y.value.f, x.value.f, box(y), box(x)); }
    static Value turning(const Enclosure<Real>& g, const Box& at, Turn<Real> turn, In y, In x) {
        // No plane goes across the cut.
        if (g.continuous) {
            turn.curvature = select(*g.continuous, turn.curvature, like(turn.curvature, infinity));
        }
        const Form f = angle_form(y.value.f, x.value.f, turn, at, g.range);
        const auto [by_y, by_x] = angle_slopes(y.value.f, x.value.f, turn);
        const Slope slope = sum(times(by_y, y.value.slope), times(by_x, x.value.slope));
        return with_domain(of(f, slope, y, x), g);
    }
    Value wave(In y, In x, int n, auto at_middle);
    PolarSlope<Real> polar_slope_of(const PolarBeam<Real>& p, In y, In x);
    Value larger(In a, In b, double sign) {
        return larger(a, b, kink_of((a.value.f - b.value.f).range()), sign);
    }

    SwitchPort<Real> switches_;
    const Real* kind_ = nullptr;  ///< any number of the carrier, of the operator at work
};

}  // namespace zeroset

#include "engine/algebra/beam_branches.hpp"
#include "engine/algebra/beam_polar_algebra.hpp"
