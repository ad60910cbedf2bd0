// erf and erfc. For Re z >= 0, erfc(z) is exp(-z^2) times 2/sqrt(pi) times the integral of
// exp(-t^2 - 2 z t) over t > 0, which is at most 1 in size: |erfc(z)| <= exp(y^2 - x^2). Left of
// that, erfc(z) = 2 - erfc(-z); erf = 1 - erfc.

#include "engine/special/families.hpp"
#include "engine/special/mpfr_value.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

constexpr double erf_end = 32;

/// A bound of ln|erfc(z)| where Re z >= 0.
double log_erfc(const ComplexBox& box) {
    const double nearest = std::max(box.from, 0.0);
    return box.height * box.height - nearest * nearest;
}
double log_more(double size, double log_bound) { return std::log(size + std::exp(log_bound)); }

ValueBounds near_limit(double value, int order) {
    constexpr double derivatives = 1e-290;  // of exp(-x^2), x >= 32
    if (order > 0) return {.lo = -derivatives, .hi = derivatives};
    return {.lo = value - 0x1p-52, .hi = value};
}

/// For x >= 3 by the continued fraction exp(-x^2)/sqrt(pi)/(x + 1/2/(x + 2/2/(x + 3/2/...))), whose
/// convergents lie on both sides of it and are equal to 118 bits here. MPFR takes milliseconds.
void set_erfc(mpfr_ptr to, mpfr_srcptr x) {
    constexpr unsigned long from = 3;
    if (mpfr_cmp_ui(x, from) < 0) {
        mpfr_erfc(to, x, MPFR_RNDN);
        return;
    }
    constexpr mpfr_prec_t more = 16;
    MpfrValue fraction(mpfr_get_prec(to) + more);
    MpfrValue power(mpfr_get_prec(to) + more);
    mpfr_set(fraction, x, MPFR_RNDN);
    constexpr unsigned long terms = 120;
    for (unsigned long k = terms; k > 0; --k) {
        mpfr_ui_div(fraction, k, fraction, MPFR_RNDN);
        mpfr_div_2ui(fraction, fraction, 1, MPFR_RNDN);
        mpfr_add(fraction, fraction, x, MPFR_RNDN);
    }
    mpfr_const_pi(power, MPFR_RNDN);
    mpfr_sqrt(power, power, MPFR_RNDN);
    mpfr_mul(fraction, fraction, power, MPFR_RNDN);
    mpfr_sqr(power, x, MPFR_RNDN);
    mpfr_neg(power, power, MPFR_RNDN);
    mpfr_exp(power, power, MPFR_RNDN);
    mpfr_div(to, power, fraction, MPFR_RNDN);
}

}  // namespace

PiecedLine erf_line() {
    auto pieces = std::make_shared<const Pieces>(
        Analytic{.value = [](mpfr_ptr to, mpfr_srcptr x) { mpfr_erf(to, x, MPFR_RNDN); },
                 .log_bound = [](const ComplexBox& box) { return log_more(1, log_erfc(box)); },
                 .widest = 0.125,
                 .end = erf_end,
                 .beyond = [](int order) { return near_limit(1, order); }});
    return {.name = "erf", .arguments = "(#)", .right = pieces, .left = pieces, .left_sign = -1};
}

PiecedLine erfc_line() {
    auto right = std::make_shared<const Pieces>(Analytic{
        .value = set_erfc,
        .log_bound =
            [](const ComplexBox& box) {
                return box.from < 0 ? log_more(2, log_erfc(box)) : log_erfc(box);
            },
        .widest = 0.125,
        .end = erf_end,
        .beyond =
            [](int order) {
                return order == 0 ? ValueBounds{.lo = 0, .hi = 1e-290} : near_limit(0, order);
            }});
    auto left = std::make_shared<const Pieces>(
        Analytic{.value =
                     [](mpfr_ptr to, mpfr_srcptr x) {
                         mpfr_neg(to, x, MPFR_RNDN);
                         mpfr_erfc(to, to, MPFR_RNDN);
                     },
                 .log_bound = [](const ComplexBox& box) { return log_more(2, log_erfc(box)); },
                 .widest = 0.125,
                 .end = erf_end,
                 .beyond = [](int order) { return near_limit(2, order); }});
    return {.name = "erfc", .arguments = "(#)", .right = right, .left = left};
}

}  // namespace zeroset
