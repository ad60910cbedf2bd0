#include "engine/language/values/complex_functions.hpp"

#include "engine/expr/constants.hpp"
#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace zeroset {
namespace {

constexpr int longest_binomial = 12;  // beyond it squares take fewer operations
constexpr long long largest_power = 1000;

}  // namespace

bool ComplexFunctions::is_zero(NodeId id) const {
    const Node& node = builder_.node(id);
    return node.op == Op::Constant && node.lo == 0.0 && node.hi == 0.0;
}

NodeId ComplexFunctions::minus(NodeId a) { return is_zero(a) ? a : make_negate(builder_, a); }

NodeId ComplexFunctions::times(NodeId a, NodeId b) {
    if (is_zero(a)) return a;
    return is_zero(b) ? b : make_multiply(builder_, a, b);
}

NodeId ComplexFunctions::squares(const ComplexNodes& a) {
    return make_add(builder_, make_int_power(builder_, a.re, 2), make_int_power(builder_, a.im, 2));
}

std::optional<NodeId> ComplexFunctions::polar_length(const ComplexNodes& a) {
    struct Parts {
        std::optional<NodeId> length;
        Node wave;
    };
    const auto parts = [&](NodeId id) {
        if (builder_.node(id).op == Op::Negate) id = builder_.node(id).a;
        const Node& node = builder_.node(id);
        if (node.op != Op::Multiply) return Parts{.length = std::nullopt, .wave = node};
        return Parts{.length = node.a, .wave = builder_.node(node.b)};
    };
    const Parts across = parts(a.re);
    const Parts up = parts(a.im);
    const bool is_polar = across.wave.op == Op::Cos && up.wave.op == Op::Sin &&
                          across.wave.a == up.wave.a && across.length == up.length;
    if (!is_polar) return std::nullopt;
    return across.length ? make_call(builder_, Op::Abs, *across.length) : number(1.0);
}

NodeId ComplexFunctions::modulus(const ComplexNodes& a) {
    if (is_zero(a.im)) return make_call(builder_, Op::Abs, a.re);
    if (is_zero(a.re)) return make_call(builder_, Op::Abs, a.im);
    if (const auto length = polar_length(a)) return *length;
    return make_call(builder_, Op::Sqrt, squares(a));
}

NodeId ComplexFunctions::argument(const ComplexNodes& a) {
    return make_call(builder_, Op::Atan2, a.im, a.re);
}

ComplexNodes ComplexFunctions::negative(const ComplexNodes& a) {
    return {.re = minus(a.re), .im = minus(a.im)};
}

ComplexNodes ComplexFunctions::sum(const ComplexNodes& a, const ComplexNodes& b) {
    return {.re = make_add(builder_, a.re, b.re), .im = make_add(builder_, a.im, b.im)};
}

ComplexNodes ComplexFunctions::difference(const ComplexNodes& a, const ComplexNodes& b) {
    return {.re = make_subtract(builder_, a.re, b.re), .im = make_subtract(builder_, a.im, b.im)};
}

ComplexNodes ComplexFunctions::product(const ComplexNodes& a, const ComplexNodes& b) {
    return {.re = make_subtract(builder_, times(a.re, b.re), times(a.im, b.im)),
            .im = make_add(builder_, times(a.re, b.im), times(a.im, b.re))};
}

ComplexNodes ComplexFunctions::quotient(const ComplexNodes& a, const ComplexNodes& b) {
    const auto over = [&](NodeId above, NodeId below) {
        return is_zero(above) ? above : make_divide(builder_, above, below);
    };
    if (is_zero(b.im)) return {.re = make_divide(builder_, a.re, b.re), .im = over(a.im, b.re)};
    const ComplexNodes above = product(a, {.re = b.re, .im = minus(b.im)});
    const NodeId below = squares(b);
    return {.re = over(above.re, below), .im = over(above.im, below)};
}

/// length (cos angle + i sin angle).
ComplexNodes ComplexFunctions::polar(NodeId length, NodeId angle) {
    return {.re = times(length, make_call(builder_, Op::Cos, angle)),
            .im = times(length, make_call(builder_, Op::Sin, angle))};
}

/// The real and the imaginary part of (re + i im)^n as sums over binomial coefficients.
ComplexNodes ComplexFunctions::by_binomials(const ComplexNodes& a, int n) {
    ComplexNodes result{.re = number(0.0), .im = number(0.0)};
    double coefficient = 1.0;  // n over k
    for (int k = 0; k <= n; ++k) {
        const bool vanishes = (is_zero(a.re) && k < n) || (is_zero(a.im) && k > 0);
        if (!vanishes) {
            const NodeId powers = make_multiply(builder_, make_int_power(builder_, a.re, n - k),
                                                make_int_power(builder_, a.im, k));
            const NodeId term = make_multiply(builder_, number(coefficient), powers);
            NodeId& part = k % 2 == 0 ? result.re : result.im;
            part = k % 4 < 2 ? make_add(builder_, part, term) : make_subtract(builder_, part, term);
        }
        coefficient = coefficient * (n - k) / (k + 1);
    }
    return result;
}

ComplexNodes ComplexFunctions::whole_power(const ComplexNodes& a, int n) {
    if (n < 0) return quotient(real(1.0), whole_power(a, -n));
    if (n <= longest_binomial) return by_binomials(a, n);
    const ComplexNodes half = whole_power(a, n / 2);
    const ComplexNodes even = by_binomials(half, 2);
    return n % 2 == 0 ? even : product(even, a);
}

ComplexNodes ComplexFunctions::power(const ComplexNodes& a, const ComplexNodes& b) {
    const auto exponent = is_real(b) ? exact_fraction(builder_, b.re) : std::nullopt;
    if (exponent && exponent->q == 1 && std::abs(exponent->p) <= largest_power)
        return whole_power(a, static_cast<int>(exponent->p));
    if (exponent && exponent->q == 2 && std::abs(exponent->p) <= largest_power)
        return whole_power(square_root(a), static_cast<int>(exponent->p));
    if (is_real(b)) {
        const NodeId length = make_power(builder_, modulus(a), b.re);
        return polar(length, times(b.re, argument(a)));
    }
    if (!is_real(a)) return exponential(product(b, logarithm(a)));
    const bool is_euler = is_named(builder_.node(a.re), euler);
    const NodeId slope = is_euler ? number(1.0) : make_call(builder_, Op::Log, a.re);
    const NodeId length = is_zero(b.re) ? number(1.0) : make_power(builder_, a.re, b.re);
    return polar(length, times(slope, b.im));
}

ComplexNodes ComplexFunctions::exponential(const ComplexNodes& a) {
    const NodeId length = is_zero(a.re) ? number(1.0) : make_call(builder_, Op::Exp, a.re);
    return polar(length, a.im);
}

ComplexNodes ComplexFunctions::logarithm(const ComplexNodes& a) {
    return {.re = make_call(builder_, Op::Log, modulus(a)), .im = argument(a)};
}

/// sqrt((|a| + re)/2) and sqrt((|a| - re)/2) with the sign of im, of which rounding makes no root
/// of a number below 0.
ComplexNodes ComplexFunctions::square_root(const ComplexNodes& a) {
    const NodeId length = modulus(a);
    const auto root = [&](NodeId twice) {
        const NodeId half = make_divide(builder_, twice, number(2.0));
        return make_call(builder_, Op::Sqrt, make_call(builder_, Op::Max, half, number(0.0)));
    };
    const NodeId height = root(make_subtract(builder_, length, a.re));
    const NodeId below = make_call(builder_, Op::Less, a.im, number(0.0));
    return {.re = root(make_add(builder_, length, a.re)),
            .im = make_call(builder_, Op::If, below, make_negate(builder_, height), height)};
}

ComplexNodes ComplexFunctions::sine(const ComplexNodes& a) {
    return {.re = times(make_call(builder_, Op::Sin, a.re), make_call(builder_, Op::Cosh, a.im)),
            .im = times(make_call(builder_, Op::Cos, a.re), make_call(builder_, Op::Sinh, a.im))};
}

ComplexNodes ComplexFunctions::cosine(const ComplexNodes& a) {
    return {.re = times(make_call(builder_, Op::Cos, a.re), make_call(builder_, Op::Cosh, a.im)),
            .im = minus(
                times(make_call(builder_, Op::Sin, a.re), make_call(builder_, Op::Sinh, a.im)))};
}

/// (sin 2 re + i sinh 2 im)/(cos 2 re + cosh 2 im), whose divisor is 0 at the poles only.
ComplexNodes ComplexFunctions::tangent(const ComplexNodes& a) {
    const NodeId across = times(number(2.0), a.re);
    const NodeId up = times(number(2.0), a.im);
    const NodeId below =
        make_add(builder_, make_call(builder_, Op::Cos, across), make_call(builder_, Op::Cosh, up));
    return {.re = make_divide(builder_, make_call(builder_, Op::Sin, across), below),
            .im = make_divide(builder_, make_call(builder_, Op::Sinh, up), below)};
}

/// ln(a + sqrt(a^2 + 1)).
ComplexNodes ComplexFunctions::area_sine(const ComplexNodes& a) {
    return logarithm(sum(a, square_root(sum(whole_power(a, 2), real(1.0)))));
}

/// ln(a + sqrt(a - 1) sqrt(a + 1)).
ComplexNodes ComplexFunctions::area_cosine(const ComplexNodes& a) {
    const ComplexNodes below = square_root(difference(a, real(1.0)));
    return logarithm(sum(a, product(below, square_root(sum(a, real(1.0))))));
}

/// (ln(1 + a) - ln(1 - a))/2.
ComplexNodes ComplexFunctions::area_tangent(const ComplexNodes& a) {
    const ComplexNodes twice =
        difference(logarithm(sum(real(1.0), a)), logarithm(difference(real(1.0), a)));
    return quotient(twice, real(2.0));
}

ComplexNodes ComplexFunctions::arc_sine(const ComplexNodes& a) {
    return turned_back(area_sine(turned(a)));
}

ComplexNodes ComplexFunctions::arc_cosine(const ComplexNodes& a) {
    const NodeId half_turn = make_constant(builder_, pi);
    const ComplexNodes quarter{.re = make_divide(builder_, half_turn, number(2.0)),
                               .im = number(0.0)};
    return difference(quarter, arc_sine(a));
}

std::optional<ComplexNodes> ComplexFunctions::call(Op function, const ComplexNodes& a) {
    using Self = ComplexFunctions;
    using Row = std::pair<Op, ComplexNodes (Self::*)(const ComplexNodes&)>;
    static constexpr std::array rows{Row(Op::Exp, &Self::exponential),
                                     Row(Op::Log, &Self::logarithm),
                                     Row(Op::Sqrt, &Self::square_root),
                                     Row(Op::Sin, &Self::sine),
                                     Row(Op::Cos, &Self::cosine),
                                     Row(Op::Tan, &Self::tangent),
                                     Row(Op::Cot, &Self::cotangent),
                                     Row(Op::Sinh, &Self::hyperbolic_sine),
                                     Row(Op::Cosh, &Self::hyperbolic_cosine),
                                     Row(Op::Tanh, &Self::hyperbolic_tangent),
                                     Row(Op::Asin, &Self::arc_sine),
                                     Row(Op::Acos, &Self::arc_cosine),
                                     Row(Op::Atan, &Self::arc_tangent),
                                     Row(Op::Asinh, &Self::area_sine),
                                     Row(Op::Acosh, &Self::area_cosine),
                                     Row(Op::Atanh, &Self::area_tangent)};
    const auto* const row = std::ranges::find(rows, function, &Row::first);
    return row == rows.end() ? std::nullopt : std::optional((this->*row->second)(a));
}

}  // namespace zeroset
