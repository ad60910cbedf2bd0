// Writes out polynomials with names: Legendre's, Hermite's, Laguerre's, Chebyshev's, spherical
// harmonics [DLMF, ch. 14, 18].

#include "engine/base/translation.hpp"
#include "engine/expr/constants.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/expressions/calls.hpp"

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Coefficients from the power 0 on, whole numbers that a double holds, over a common divisor.
struct Polynomial {
    std::vector<double> coefficients;
    double divisor = 1.0;
};

constexpr int highest_degree = 20;       // 2^20 P_20 and H_20 have coefficients below 2^53
constexpr int highest_of_laguerre = 12;  // of the order, too: so has 12! L_12
constexpr int highest_of_harmonics = 9;  // 18! is below 2^53

double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

double over(int n, int k) {
    double result = 1.0;
    for (int i = 1; i <= k; ++i)
        result = result * (n - k + i) / i;
    return result;
}

/// (a + b x) p + c q of polynomials in x.
std::vector<double> next_of(double a, double b, const std::vector<double>& p, double c,
                            const std::vector<double>& q) {
    std::vector<double> result(p.size() + 1, 0.0);
    for (std::size_t k = 0; k < p.size(); ++k) {
        result[k] += a * p[k];
        result[k + 1] += b * p[k];
    }
    for (std::size_t k = 0; k < q.size(); ++k)
        result[k] += c * q[k];
    return result;
}

/// 2^n P_n: the sum over k of (-1)^k (n over k) (2 n - 2 k over n) x^(n - 2 k), less their common
/// factors of 2.
Polynomial legendre(int n) {
    Polynomial result{.coefficients = std::vector<double>(static_cast<std::size_t>(n) + 1, 0.0),
                      .divisor = static_cast<double>(1LL << n)};
    for (int k = 0; 2 * k <= n; ++k) {
        const double size = over(n, k) * over(2 * n - 2 * k, n);
        result.coefficients[static_cast<std::size_t>(n - 2 * k)] = k % 2 == 0 ? size : -size;
    }
    const auto halves = [&] {
        for (const double c : result.coefficients) {
            if (static_cast<long long>(c) % 2 != 0) return false;
        }
        return result.divisor > 1.0;
    };
    while (halves()) {
        for (double& c : result.coefficients)
            c /= 2.0;
        result.divisor /= 2.0;
    }
    return result;
}

/// n! L_n^k: the sum over j of (-1)^j n!/j! (n + k over n - j) x^j.
Polynomial laguerre(int n, int order) {
    Polynomial result{.coefficients = {}, .divisor = factorial(n)};
    for (int j = 0; j <= n; ++j) {
        const double size = factorial(n) / factorial(j) * over(n + order, n - j);
        result.coefficients.push_back(j % 2 == 0 ? size : -size);
    }
    return result;
}

/// H_n, T_n and U_n by their recurrences.
Polynomial hermite(int n) {
    std::vector<double> before;
    std::vector<double> here{1.0};
    for (int k = 0; k < n; ++k)
        before = std::exchange(here, next_of(0.0, 2.0, here, -2.0 * k, before));
    return {.coefficients = here};
}

Polynomial chebyshev(int n, bool is_second) {
    std::vector<double> before = is_second ? std::vector<double>{} : std::vector<double>{0.0, 1.0};
    std::vector<double> here{1.0};
    for (int k = 0; k < n; ++k)
        before = std::exchange(here, next_of(0.0, 2.0, here, -1.0, before));
    here.resize(static_cast<std::size_t>(n) + 1);
    return {.coefficients = here};
}

Polynomial derivative(Polynomial of, int order) {
    for (; order > 0; --order) {
        for (std::size_t k = 1; k < of.coefficients.size(); ++k)
            of.coefficients[k - 1] = static_cast<double>(k) * of.coefficients[k];
        of.coefficients.pop_back();
    }
    return of;
}

GraphValues::Built number(const CallSite& site, double value) {
    return site.values().done(site.builder().constant(value), site.offset());
}

GraphValues::Built combined(const CallSite& site, const GraphValues::Built& a,
                            const GraphValues::Built& b, GraphValues::Binary make) {
    return a && b ? site.values().combined(*a, *b, site.offset(), make) : std::nullopt;
}

/// The polynomial of a value, the highest power first.
GraphValues::Built value_of(const CallSite& site, const Polynomial& polynomial,
                            const BuiltValue& at) {
    GraphValues::Built total;
    for (std::size_t k = polynomial.coefficients.size(); k-- > 0;) {
        const double coefficient = polynomial.coefficients[k];
        if (coefficient == 0.0) continue;
        GraphValues::Built term = number(site, std::abs(coefficient));
        if (k > 0) {
            const auto power = combined(site, at, number(site, static_cast<double>(k)), make_power);
            term = combined(site, term, power, make_multiply);
        }
        if (!total && coefficient < 0.0)
            term = combined(site, number(site, 0.0), term, make_subtract);
        total = total ? combined(site, total, term, coefficient < 0.0 ? make_subtract : make_add)
                      : term;
        if (!total) return total;
    }
    if (!total) return number(site, 0.0);
    return combined(site, total, number(site, polynomial.divisor), make_divide);
}

/// A degree or an order, from `least` to `most`.
std::optional<int> count_at(const CallSite& site, std::size_t place, int least, int most) {
    const std::string rule =
        filled(tr("the degree and the order of {0} are whole numbers"), {site.word()});
    const std::string hint = filled(tr("type whole numbers from {0} to {1}"),
                                    {std::to_string(least), std::to_string(most)});
    const auto value = site.reader.whole_number(site.call.operands[place], site.context,
                                                {.reason = rule, .hint = hint});
    if (!value) return std::nullopt;
    if (*value >= least && *value <= most) return static_cast<int>(*value);
    refuse_argument(site, place, rule, hint);
    return std::nullopt;
}

/// |sin t| of a = cos t, else sqrt(1 - a^2).
NodeId sine_of(const CallSite& site, NodeId a) {
    ExprBuilder& builder = site.builder();
    const Node node = builder.node(a);
    if (node.op == Op::Cos) return make_call(builder, Op::Abs, make_call(builder, Op::Sin, node.a));
    return make_call(builder, Op::Sqrt,
                     make_subtract(builder, builder.constant(1.0), make_int_power(builder, a, 2)));
}

/// P_n^m = (-1)^m (1 - a^2)^(m/2) times the derivative of P_n of order m.
GraphValues::Built associated(const CallSite& site, int n, int m, const BuiltValue& a) {
    GraphValues::Built value = value_of(site, derivative(legendre(n), m), a);
    const auto cosine = value ? site.values().number_of(a, site.offset()) : std::nullopt;
    if (!cosine) return std::nullopt;
    ExprBuilder& builder = site.builder();
    const NodeId sine = make_int_power(builder, sine_of(site, *cosine), m);
    const NodeId all = make_multiply(builder, sine, value->id);
    return site.values().done(m % 2 == 0 ? all : make_negate(builder, all), site.offset());
}

/// The polynomial of the call for a degree.
GraphValues::Built of_degree(const CallSite& site, int n, const BuiltValue& a) {
    const bool has_order = site.call.operands.size() == 3;
    if (site.composed() == Composed::Hermite) return value_of(site, hermite(n), a);
    const bool is_second = site.composed() == Composed::ChebyshevU;
    if (is_second || site.composed() == Composed::Chebyshev)
        return value_of(site, chebyshev(n, is_second), a);
    if (site.composed() == Composed::Laguerre) {
        const auto order = has_order ? count_at(site, 1, 0, highest_of_laguerre) : 0;
        return order ? value_of(site, laguerre(n, *order), a) : std::nullopt;
    }
    if (!has_order) return value_of(site, legendre(n), a);
    const auto order = count_at(site, 1, 0, n);
    return order ? associated(site, n, *order, a) : std::nullopt;
}

/// sqrt((2 l + 1)(l - m)!/(4 pi (l + m)!)) P_l^m(cos polar) e^(i m azimuth), where the order -m has
/// the conjugate of that of m times (-1)^m.
GraphValues::Built harmonic(const CallSite& site, int l, int m, const BuiltValue& polar,
                            const BuiltValue& azimuth) {
    ExprBuilder& builder = site.builder();
    const auto theta = site.values().number_of(polar, site.offset_of(2));
    const auto phi = theta ? site.values().number_of(azimuth, site.offset_of(3)) : std::nullopt;
    if (!phi) return std::nullopt;
    const int order = std::abs(m);
    const BuiltValue cosine{.id = make_call(builder, Op::Cos, *theta)};
    const auto slopes = value_of(site, derivative(legendre(l), order), cosine);
    if (!slopes) return std::nullopt;
    const NodeId sine = make_int_power(builder, make_call(builder, Op::Sin, *theta), order);
    const NodeId circle =
        make_multiply(builder, builder.constant(4.0 * factorial(l + order) / factorial(l - order)),
                      make_constant(builder, pi));
    const NodeId factor =
        make_call(builder, Op::Sqrt, make_divide(builder, builder.constant(2.0 * l + 1.0), circle));
    NodeId length = make_multiply(builder, factor, make_multiply(builder, sine, slopes->id));
    if (m > 0 && m % 2 != 0) length = make_negate(builder, length);
    if (m == 0) return site.values().done(length, site.offset());
    const NodeId angle = make_multiply(builder, builder.constant(order), *phi);
    NodeId im = make_multiply(builder, length, make_call(builder, Op::Sin, angle));
    if (m < 0) im = make_negate(builder, im);
    const NodeId re = make_multiply(builder, length, make_call(builder, Op::Cos, angle));
    return site.values().complex({.re = re, .im = im}, site.offset());
}

}  // namespace

GraphValues::Built read_polynomial(const CallSite& site) {
    const Composed kind = site.composed();
    const bool is_harmonic = kind == Composed::Harmonic;
    const int most = is_harmonic                  ? highest_of_harmonics
                     : kind == Composed::Laguerre ? highest_of_laguerre
                                                  : highest_degree;
    const auto degree = count_at(site, 0, 0, most);
    if (!degree) return std::nullopt;
    const auto last = site.reader.operand(site.call.operands.back(), site.context);
    if (!last) return std::nullopt;
    if (!is_harmonic) return of_degree(site, *degree, *last);
    const auto order = count_at(site, 1, -*degree, *degree);
    const auto polar =
        order ? site.reader.operand(site.call.operands[2], site.context) : std::nullopt;
    return polar ? harmonic(site, *degree, *order, *polar, *last) : std::nullopt;
}

}  // namespace zeroset
