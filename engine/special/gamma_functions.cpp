// 1/gamma, ln(gamma) and digamma.
//
// |gamma(x + i y)| >= gamma(x)/sqrt(cosh(pi y)) for x >= 1/2 [DLMF, 5.6.7], and 1/gamma(z) =
// sin(pi z) gamma(1 - z)/pi with |gamma(1 - z)| <= gamma(1 - x) left of that. ln(gamma(z)) differs
// for x > 0 from (z - 1/2) ln(z) - z + ln(2 pi)/2 by the integral of phi(t) exp(-z t), t > 0, with
// 0 < phi < 1/12 (Binet): by at most 1/(12 x), and its derivative by at most 1/(12 x^2).

#include "engine/special/families.hpp"
#include "engine/special/mpfr_value.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

constexpr double gamma_end = 160;  // gamma and its derivatives are numbers of double

double log_reciprocal_gamma(const ComplexBox& box) {
    using std::numbers::pi;
    constexpr double lowest_of_gamma = 0.8856;  // at 1.4616, from where on gamma grows
    const double turn = pi * box.height;        // cosh(t) <= exp(t)
    double bound =
        0.5 * turn - (box.from < 1.4616 ? std::log(lowest_of_gamma) : std::lgamma(box.from) - 1e-6);
    if (box.from < 0.5) {
        const double most = std::max(std::lgamma(1 - box.from), std::log(1.78));  // convex
        bound = std::max(bound, turn + most + 1e-6 - std::log(pi));
    }
    return bound;
}

double log_gamma_bound(const ComplexBox& box) {
    const double size = box.radius();
    const double logarithm =
        std::max(std::abs(std::log(box.from)), std::abs(std::log(size))) + std::numbers::pi / 2;
    return std::log((size + 0.5) * logarithm + size + 1 + 1 / (12 * box.from));
}
double log_digamma_bound(const ComplexBox& box) {
    const double logarithm =
        std::max(std::abs(std::log(box.from)), std::abs(std::log(box.radius())));
    return std::log(logarithm + std::numbers::pi / 2 + 0.5 / box.from +
                    1 / (12 * box.from * box.from));
}

void set_reciprocal_gamma(mpfr_ptr to, mpfr_srcptr x) {
    mpfr_gamma(to, x, MPFR_RNDN);
    mpfr_ui_div(to, 1, to, MPFR_RNDN);
}

constexpr int first_gamma_octave = -20;
constexpr double far_gamma = 0x1p60;

}  // namespace

PiecedLine reciprocal_gamma_line() {
    auto right = std::make_shared<const Pieces>(
        Analytic{.value = set_reciprocal_gamma,
                 .log_bound = log_reciprocal_gamma,
                 .widest = 0.25,
                 .end = gamma_end,
                 .beyond = [](int order) {
                     constexpr double most = 1e-270;
                     return ValueBounds{.lo = order == 0 ? 0 : -most, .hi = most};
                 }});
    auto left = std::make_shared<const Pieces>(
        Analytic{.value =
                     [](mpfr_ptr to, mpfr_srcptr x) {
                         mpfr_neg(to, x, MPFR_RNDN);
                         set_reciprocal_gamma(to, to);
                     },
                 .log_bound =
                     [](const ComplexBox& box) {
                         return log_reciprocal_gamma(
                             {.from = -box.to, .to = -box.from, .height = box.height});
                     },
                 .widest = 0.25,
                 .end = gamma_end,
                 .beyond = [](int) { return ValueBounds{.lo = -unbounded, .hi = unbounded}; }});
    return {.name = "rgamma", .arguments = "(#)", .right = right, .left = left};
}

PiecedLine log_gamma_line() {
    return {.name = "loggamma",
            .arguments = "(#)",
            .right = std::make_shared<const Pieces>(Analytic{
                .value = [](mpfr_ptr to, mpfr_srcptr x) { mpfr_lngamma(to, x, MPFR_RNDN); },
                .log_bound = log_gamma_bound,
                .first = first_gamma_octave,
                .from_zero = false,
                .end = far_gamma,
                .beyond =
                    [](int order) {
                        return order < 2 ? ValueBounds{.lo = 0, .hi = unbounded}
                                         : ValueBounds{.lo = -1, .hi = 1};
                    },
                .everywhere =
                    [](int order) {
                        constexpr double lowest = -0.1215;
                        return ValueBounds{.lo = order == 0 ? lowest : -unbounded, .hi = unbounded};
                    },
                .sign_at_zero = 1}),
            .left = nullptr};
}

PiecedLine digamma_line() {
    return {.name = "digamma_right",
            .arguments = "(#)",
            .right = std::make_shared<const Pieces>(Analytic{
                .value = [](mpfr_ptr to, mpfr_srcptr x) { mpfr_digamma(to, x, MPFR_RNDN); },
                .log_bound = log_digamma_bound,
                .first = first_gamma_octave,
                .from_zero = false,
                .end = far_gamma,
                .beyond =
                    [](int order) {
                        return order < 1 ? ValueBounds{.lo = 0, .hi = unbounded}
                                         : ValueBounds{.lo = -1, .hi = 1};
                    },
                .sign_at_zero = -1}),
            .left = nullptr};
}

}  // namespace zeroset
