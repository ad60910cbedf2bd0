// The principal branch of W at z = (p^2 - 1)/e, an even function of p with an edge at 0. The square
// root of e z + 1 takes away the branch point, so that this is analytic for Re p >= 0 and in |p|
// < 1. For Re p >= 0, |Im W| < pi and Re W > -1; as ln|W| + Re W = ln|z|, |W| <= 1 + pi +
// max(ln|z|, 0). Where |p| <= 0.7, |z| is from 0.18 to 0.55 and |Im W| < 3 pi, so that |W| <= 14
// [Corless96].

#include "engine/special/families.hpp"
#include "engine/special/mpfr_value.hpp"

#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

constexpr mpfr_prec_t newton_bits = 320;

double log_lambert_bound(const ComplexBox& box) {
    constexpr double disc = 0.7;
    const double size = box.radius();
    if (box.from < 0) return size <= disc ? std::log(14.0) : unbounded;
    return std::log(1 + std::numbers::pi + std::log1p(size * size));
}

double first_guess(double p) {
    if (p < 1) return -1 + std::numbers::sqrt2 * p - 0.6 * p * p;
    const double logarithm = 2 * std::log(p);
    return logarithm < 3 ? 0.6 * logarithm : logarithm - 1 - std::log(logarithm - 1);
}

/// Solves w exp(w) = (p^2 - 1)/e by Newton's method.
void set_lambert(mpfr_ptr to, mpfr_srcptr p) {
    MpfrValue z(newton_bits);
    MpfrValue w(newton_bits, first_guess(mpfr_get_d(p, MPFR_RNDN)));
    MpfrValue power(newton_bits);
    MpfrValue step(newton_bits);
    mpfr_sqr(z, p, MPFR_RNDN);
    mpfr_sub_ui(z, z, 1, MPFR_RNDN);
    mpfr_set_si(power, -1, MPFR_RNDN);
    mpfr_exp(power, power, MPFR_RNDN);
    mpfr_mul(z, z, power, MPFR_RNDN);
    constexpr int most_steps = 100;
    constexpr mpfr_exp_t small = -140;
    for (int n = 0; n < most_steps; ++n) {
        // w - (w - z exp(-w))/(1 + w)
        mpfr_neg(power, w, MPFR_RNDN);
        mpfr_exp(power, power, MPFR_RNDN);
        mpfr_mul(power, power, z, MPFR_RNDN);
        mpfr_sub(step, w, power, MPFR_RNDN);
        mpfr_add_ui(power, w, 1, MPFR_RNDN);
        mpfr_div(step, step, power, MPFR_RNDN);
        mpfr_sub(w, w, step, MPFR_RNDN);
        if (mpfr_zero_p(static_cast<mpfr_srcptr>(step)) != 0 || mpfr_get_exp(step) < small) break;
    }
    mpfr_set(to, w, MPFR_RNDN);
}

}  // namespace

PiecedLine lambert_line() {
    auto pieces = std::make_shared<const Pieces>(
        Analytic{.value = set_lambert,
                 .log_bound = log_lambert_bound,
                 .end = 0x1p64,  // the root of e times the largest float
                 .beyond =
                     [](int order) {
                         return order == 0 ? ValueBounds{.lo = 80, .hi = unbounded}
                                           : ValueBounds{.lo = -1, .hi = 1};
                     },
                 .everywhere =
                     [](int order) {
                         return ValueBounds{.lo = order == 0 ? -1 : -unbounded, .hi = unbounded};
                     }});
    return {.name = "lambertw_root", .arguments = "(#)", .right = pieces, .left = pieces};
}

}  // namespace zeroset
