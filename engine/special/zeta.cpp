// (x - 1) zeta(x), which has no pole.
//
// By Euler and Maclaurin, for Re s > -3, zeta(s) differs from 1/(s - 1) + 1/2 + s/12 by at most
// |s (s + 1) (s + 2) (s + 3)|/(720 (Re s + 3)), as |B_4({t})| <= 1/30. For Re s < 0 it is
// 2 (2 pi)^(s - 1) sin(pi s/2) gamma(1 - s) zeta(1 - s), and |zeta(z)| <= zeta(Re z), Re z > 1.

#include "engine/special/families.hpp"
#include "engine/special/mpfr_value.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zeroset {
namespace {

constexpr double zeta_of_two = 1.645;
constexpr double zeta_left_end = 160;  // zeta is a number of double there
constexpr double zeta_right_end = 0x1p40;

/// Bounds |(s - 1) zeta(s)| where Re s >= -1.
double zeta_right_bound(const ComplexBox& box) {
    const double size = box.radius();
    if (box.from >= 2) return (size + 1) * zeta_of_two;
    const double product = size * (size + 1) * (size + 2) * (size + 3);
    const double nearest = std::max(box.from, -1.0) + 3;
    return 1 + (size + 1) * (0.5 + size / 12 + product / (720 * nearest));
}
/// ln of such a bound where Re s <= -1.
double log_zeta_left_bound(const ComplexBox& box) {
    const double farthest = 1 - box.from;
    const double nearest = std::max(1 - box.to, 2.0);
    const double turn = 0.5 * std::numbers::pi * box.height;
    return std::log(box.radius() + 1) + std::log(2 * zeta_of_two) + turn + std::lgamma(farthest) +
           1e-6 - nearest * std::log(2 * std::numbers::pi);
}
double log_zeta_bound(const ComplexBox& box) {
    double bound = box.to > -1 ? std::log(zeta_right_bound(box)) : -unbounded;
    if (box.from < -1) bound = std::max(bound, log_zeta_left_bound(box));
    return bound;
}

void set_product(mpfr_ptr to, mpfr_srcptr s) {
    MpfrValue less(mpfr_get_prec(to));
    mpfr_sub_ui(less, s, 1, MPFR_RNDN);
    mpfr_zeta(to, s, MPFR_RNDN);
    mpfr_mul(to, to, less, MPFR_RNDN);
}

}  // namespace

PiecedLine zeta_line() {
    auto right = std::make_shared<const Pieces>(
        Analytic{.value = set_product,
                 .log_bound = log_zeta_bound,
                 .first = 2,
                 .end = zeta_right_end,
                 .beyond = [](int order) {
                     return order == 0 ? ValueBounds{.lo = 0x1p39, .hi = unbounded}
                                       : ValueBounds{.lo = -2, .hi = 2};
                 }});
    auto left = std::make_shared<const Pieces>(Analytic{
        .value =
            [](mpfr_ptr to, mpfr_srcptr x) {
                MpfrValue s(mpfr_get_prec(x));
                mpfr_neg(s, x, MPFR_RNDN);
                set_product(to, s);
            },
        .log_bound =
            [](const ComplexBox& box) {
                return log_zeta_bound({.from = -box.to, .to = -box.from, .height = box.height});
            },
        .first = 2,
        .widest = 0.5,
        .end = zeta_left_end,
        .beyond = [](int) { return ValueBounds{.lo = -unbounded, .hi = unbounded}; }});
    return {.name = "zeta_times", .arguments = "(#)", .right = right, .left = left};
}

}  // namespace zeroset
