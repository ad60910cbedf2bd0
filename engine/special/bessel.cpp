// Bessel functions of whole orders n >= 0. With x = Re z and y = Im z,
//   |J_n(z)| <= exp(|y|) and <= |z/2|^n exp(|y|)/n!                              [DLMF, 10.14.4]
//   Y_n(z)   is 1/pi times the integral of sin(z sin t - n t) over 0 < t < pi, less that of
//            (exp(n t) + (-1)^n exp(-n t)) exp(-z sinh t) over t > 0, for x > 0   [DLMF, 10.9.7]
//   |I_n(z)| <= exp(|x|) and <= |z/2|^n exp(|x|)/n!                              [DLMF, 10.14.4]
//   |K_n(z)| <= K_n(x) for x > 0, as K_n is the integral of exp(-z cosh t) cosh(n t) over t > 0

#include "engine/special/families.hpp"
#include "engine/special/mpfr_value.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

constexpr double oscillation_end = 4096;
constexpr double growth_end = 512;

double parity(int order) { return order % 2 == 0 ? 1 : -1; }

/// ln(|z/2|^n/n!), at most 0.
double log_first_term(int order, const ComplexBox& box) {
    return std::min(0.0, order * std::log(0.5 * box.radius()) - std::lgamma(order + 1.0) + 1e-6);
}

/// J^2 + Y^2 is at most 2/(pi sqrt(x^2 - n^2)) [Watson44, 13.74]; derivatives are means of these
/// functions of nearby orders.
ValueBounds far_oscillation(int /*order*/) { return {.lo = -0.0126, .hi = 0.0126}; }

/// The integral over t > 0 in Y_n(z), at most 2/pi times that of exp(n t - x sinh t), where
/// sinh t >= (exp(t) - 1)/2: with u = x/2 at most u^-n (n - 1)! (1 + u + u^2/2 + ... +
/// u^(n-1)/(n - 1)!), or ln(1 + 1/u) for n = 0.
double falling_part(int order, double x) {
    const double u = 0.5 * x;
    if (order == 0) return 2 / std::numbers::pi * std::log1p(1 / u);
    double sum = 0;
    for (int k = 0; k < order; ++k)
        sum += std::exp((k - order) * std::log(u) + std::lgamma(order) - std::lgamma(k + 1));
    return 2 / std::numbers::pi * sum * 1.0001;
}

/// The first octave in which a function that is about (n - 1)! (2/x)^n/2 at 0 is a number of double
/// with its derivatives.
int first_bessel_octave(int order) {
    constexpr int lowest = -20;
    constexpr double most_bits = 780;
    if (order == 0) return lowest;
    const double of_factorial = std::lgamma(order) / std::numbers::ln2;
    return std::max(lowest, 1 - static_cast<int>((most_bits - of_factorial) / order));
}

std::string bessel_arguments(int order) { return "(" + std::to_string(order) + ", #)"; }

}  // namespace

PiecedLine bessel_j_line(int order) {
    auto pieces = std::make_shared<const Pieces>(Analytic{
        .value = [order](mpfr_ptr to, mpfr_srcptr x) { mpfr_jn(to, order, x, MPFR_RNDN); },
        .log_bound =
            [order](const ComplexBox& box) { return box.height + log_first_term(order, box); },
        .widest = 1,
        .end = oscillation_end,
        .beyond = far_oscillation,
        .far = 256,
        .everywhere = [](int) { return ValueBounds{.lo = -1, .hi = 1}; }});
    return {.name = "besselj",
            .arguments = bessel_arguments(order),
            .right = pieces,
            .left = pieces,
            .left_sign = parity(order)};
}

PiecedLine bessel_y_line(int order) {
    return {.name = "bessely",
            .arguments = bessel_arguments(order),
            .right = std::make_shared<const Pieces>(Analytic{
                .value = [order](mpfr_ptr to, mpfr_srcptr x) { mpfr_yn(to, order, x, MPFR_RNDN); },
                .log_bound =
                    [order](const ComplexBox& box) {
                        return std::log(std::exp(box.height) + falling_part(order, box.from));
                    },
                .first = first_bessel_octave(order),
                .from_zero = false,
                .widest = 1,
                .end = oscillation_end,
                .beyond = far_oscillation,
                .far = 256,
                .sign_at_zero = -1}),
            .left = nullptr};
}

namespace {

/// Adds (x/2)^(2 k + n)/(k! (k + n)!) over all k, times `factor(k)` if there is one.
void set_i_series(mpfr_ptr to, int order, mpfr_srcptr x) {
    const mpfr_prec_t bits = mpfr_get_prec(to) + 32;
    MpfrValue square(bits);
    MpfrValue term(bits);
    MpfrValue sum(bits);
    const auto n = static_cast<unsigned long>(order);
    mpfr_div_2ui(square, x, 1, MPFR_RNDN);
    mpfr_pow_ui(term, square, n, MPFR_RNDN);
    mpfr_sqr(square, square, MPFR_RNDN);
    for (unsigned long k = 2; k <= n; ++k)
        mpfr_div_ui(term, term, k, MPFR_RNDN);
    mpfr_set(sum, term, MPFR_RNDN);
    for (unsigned long k = 1; mpfr_get_exp(term) + bits > mpfr_get_exp(sum) || k < 4; ++k) {
        mpfr_mul(term, term, square, MPFR_RNDN);
        mpfr_div_ui(term, term, k * (k + n), MPFR_RNDN);
        mpfr_add(sum, sum, term, MPFR_RNDN);
    }
    mpfr_set(to, sum, MPFR_RNDN);
}

/// K_0 by its series, whose terms are up to exp(2 x) times as large as their sum.
void set_k0_series(mpfr_ptr to, mpfr_srcptr x, mpfr_prec_t bits) {
    MpfrValue square(bits);
    MpfrValue term(bits, 1.0);
    MpfrValue harmonic(bits, 0.0);
    MpfrValue part(bits);
    MpfrValue sum(bits);
    // -(ln(x/2) + gamma) + the harmonic number, for each term of I_0
    mpfr_div_2ui(square, x, 1, MPFR_RNDN);
    mpfr_log(harmonic, square, MPFR_RNDN);
    mpfr_const_euler(part, MPFR_RNDN);
    mpfr_add(harmonic, harmonic, part, MPFR_RNDN);
    mpfr_neg(harmonic, harmonic, MPFR_RNDN);
    mpfr_sqr(square, square, MPFR_RNDN);
    mpfr_set(sum, harmonic, MPFR_RNDN);
    for (unsigned long k = 1; mpfr_get_exp(term) > -bits || k < 4; ++k) {
        mpfr_mul(term, term, square, MPFR_RNDN);
        mpfr_div_ui(term, term, k * k, MPFR_RNDN);
        mpfr_set_ui(part, 1, MPFR_RNDN);
        mpfr_div_ui(part, part, k, MPFR_RNDN);
        mpfr_add(harmonic, harmonic, part, MPFR_RNDN);
        mpfr_mul(part, term, harmonic, MPFR_RNDN);
        mpfr_add(sum, sum, part, MPFR_RNDN);
    }
    mpfr_set(to, sum, MPFR_RNDN);
}

/// K_0 and K_1 by their asymptotic series, whose error is at most the first term that is left out
/// [DLMF, 10.40(ii)]; for x >= 64 that falls below 2^-150.
void set_k_far(mpfr_ptr to, unsigned long order, mpfr_srcptr x) {
    const mpfr_prec_t bits = mpfr_get_prec(to);
    MpfrValue term(bits, 1.0);
    MpfrValue sum(bits, 1.0);
    const unsigned long square = 4 * order * order;
    for (unsigned long k = 1;
         mpfr_zero_p(static_cast<mpfr_srcptr>(term)) == 0 && k < 100 && mpfr_get_exp(term) > -bits;
         ++k) {
        const unsigned long odd = (2 * k - 1) * (2 * k - 1);
        mpfr_mul_si(term, term, static_cast<long>(square) - static_cast<long>(odd), MPFR_RNDN);
        mpfr_div_ui(term, term, 8 * k, MPFR_RNDN);
        mpfr_div(term, term, x, MPFR_RNDN);
        mpfr_add(sum, sum, term, MPFR_RNDN);
    }
    // sqrt(pi/(2 x)) exp(-x)
    mpfr_const_pi(term, MPFR_RNDN);
    mpfr_div(term, term, x, MPFR_RNDN);
    mpfr_div_2ui(term, term, 1, MPFR_RNDN);
    mpfr_sqrt(term, term, MPFR_RNDN);
    mpfr_mul(sum, sum, term, MPFR_RNDN);
    mpfr_neg(term, x, MPFR_RNDN);
    mpfr_exp(term, term, MPFR_RNDN);
    mpfr_mul(to, sum, term, MPFR_RNDN);
}

/// K_n by K_0 and K_1, with I_0 K_1 + I_1 K_0 = 1/x, and the recurrence upwards, of which all terms
/// are positive.
void set_k(mpfr_ptr to, int order, mpfr_srcptr x) {
    constexpr double from_there_far = 64;
    const mpfr_prec_t bits = mpfr_get_prec(to) + 48;
    MpfrValue last(bits);
    MpfrValue now(bits);
    MpfrValue part(bits);
    if (mpfr_cmp_d(x, from_there_far) >= 0) {
        set_k_far(last, 0, x);
        set_k_far(now, 1, x);
    } else {
        const auto lost = static_cast<mpfr_prec_t>(3 * mpfr_get_d(x, MPFR_RNDU)) + 32;
        set_k0_series(last, x, bits + lost);
        set_i_series(part, 1, x);
        mpfr_mul(part, part, last, MPFR_RNDN);
        mpfr_ui_div(now, 1, x, MPFR_RNDN);
        mpfr_sub(now, now, part, MPFR_RNDN);
        set_i_series(part, 0, x);
        mpfr_div(now, now, part, MPFR_RNDN);
    }
    if (order == 0) mpfr_set(now, last, MPFR_RNDN);
    for (int n = 1; n < order; ++n) {
        mpfr_mul_ui(part, now, 2 * static_cast<unsigned long>(n), MPFR_RNDN);
        mpfr_div(part, part, x, MPFR_RNDN);
        mpfr_add(part, part, last, MPFR_RNDN);
        mpfr_set(last, now, MPFR_RNDN);
        mpfr_set(now, part, MPFR_RNDN);
    }
    mpfr_set(to, now, MPFR_RNDN);
}

double log_k(int order, double x) {
    constexpr mpfr_prec_t few_bits = 40;
    MpfrValue at(few_bits, x);
    MpfrValue k(few_bits);
    set_k(k, order, at);
    mpfr_log(k, k, MPFR_RNDU);
    return mpfr_get_d(k, MPFR_RNDU) + 1e-6;
}

}  // namespace

PiecedLine bessel_i_line(int order) {
    auto pieces = std::make_shared<const Pieces>(Analytic{
        .value = [order](mpfr_ptr to, mpfr_srcptr x) { set_i_series(to, order, x); },
        .log_bound =
            [order](const ComplexBox& box) {
                return std::max(std::abs(box.from), std::abs(box.to)) + log_first_term(order, box);
            },
        .widest = 1,
        .end = growth_end,
        .beyond = [](int) { return ValueBounds{.lo = 0, .hi = unbounded}; },
        .everywhere = [](int) { return ValueBounds{.lo = 0, .hi = unbounded}; }});
    return {.name = "besseli",
            .arguments = bessel_arguments(order),
            .right = pieces,
            .left = pieces,
            .left_sign = parity(order)};
}

PiecedLine bessel_k_line(int order) {
    return {.name = "besselk",
            .arguments = bessel_arguments(order),
            .right = std::make_shared<const Pieces>(Analytic{
                .value = [order](mpfr_ptr to, mpfr_srcptr x) { set_k(to, order, x); },
                .log_bound = [order](const ComplexBox& box) { return log_k(order, box.from); },
                .first = first_bessel_octave(order),
                .from_zero = false,
                .widest = 1,
                .end = growth_end,
                .beyond = [](int) { return ValueBounds{.lo = -1e-150, .hi = 1e-150}; },
                .everywhere =
                    [](int derivative) {
                        return derivative % 2 == 0 ? ValueBounds{.lo = 0, .hi = unbounded}
                                                   : ValueBounds{.lo = -unbounded, .hi = 0};
                    },
                .sign_at_zero = 1}),
            .left = nullptr};
}

}  // namespace zeroset
