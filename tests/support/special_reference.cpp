#include "tests/support/special_reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace zeroset::test {
namespace {

constexpr double farthest = 1e5;
constexpr double farthest_growing = 600;

MpfrNumber exp_of(MpfrNumber x) {
    mpfr_exp(x.get(), x.get(), MPFR_RNDN);
    return x;
}
MpfrNumber cosh_of(MpfrNumber x) {
    mpfr_cosh(x.get(), x.get(), MPFR_RNDN);
    return x;
}
MpfrNumber cos_of(MpfrNumber x) {
    mpfr_cos(x.get(), x.get(), MPFR_RNDN);
    return x;
}

/// The mean of exp(x cos t) cos(n t) over a turn, by the trapezoidal rule, whose error is of the
/// order of I_(points - n)(x).
MpfrNumber modified_first(int n, const MpfrNumber& x) {
    const int points = 160 + n + static_cast<int>(3 * std::abs(x.nearest()));
    MpfrNumber sum(0.0);
    for (int i = 0; i < points; ++i) {
        const MpfrNumber t = test::pi() * MpfrNumber(2.0 * i) / MpfrNumber(points);
        sum = sum + exp_of(x * cos_of(t)) * cos_of(MpfrNumber(n) * t);
    }
    return sum / MpfrNumber(points);
}

/// The integral of exp(-x cosh t) cosh(n t) over t > 0 by the trapezoidal rule.
MpfrNumber modified_second(int n, const MpfrNumber& x) {
    constexpr double step = 0x1p-5;
    MpfrNumber sum = exp_of(-x) / MpfrNumber(2.0);
    for (int i = 1;; ++i) {
        const MpfrNumber t(i * step);
        const MpfrNumber term = exp_of(-(x * cosh_of(t))) * cosh_of(MpfrNumber(n) * t);
        sum = sum + term;
        const bool falls = x.nearest() * std::sinh(i * step) > n;
        if (falls && mpfr_get_exp(term.get()) + 200 < mpfr_get_exp(sum.get())) break;
    }
    return sum * MpfrNumber(step);
}

/// The w from -1 on with w exp(w) = (p^2 - 1)/e.
MpfrNumber lambert(const MpfrNumber& p) {
    const MpfrNumber z = (p * p - MpfrNumber(1.0)) / exp_of(MpfrNumber(1.0));
    MpfrNumber lo(-1.0);
    MpfrNumber hi(1.0 + std::log(1.0 + std::abs(p.nearest())) * 2.0);
    for (int i = 0; i < MpfrNumber::precision_bits; ++i) {
        const MpfrNumber middle = (lo + hi) / MpfrNumber(2.0);
        (middle * exp_of(middle) - z < 0.0 ? lo : hi) = middle;
    }
    return lo;
}

MpfrNumber reciprocal_gamma(const MpfrNumber& x) {
    if (mpfr_integer_p(x.get()) != 0 && x.sign() <= 0) return MpfrNumber(0.0);
    MpfrNumber gamma;
    mpfr_gamma(gamma.get(), x.get(), MPFR_RNDN);
    return MpfrNumber(1.0) / gamma;
}

MpfrNumber zeta_times(const MpfrNumber& x) {
    if (mpfr_cmp_ui(x.get(), 1) == 0) return MpfrNumber(1.0);
    MpfrNumber zeta;
    mpfr_zeta(zeta.get(), x.get(), MPFR_RNDN);
    return zeta * (x - MpfrNumber(1.0));
}

bool is_right_only(SpecialFunction function) {
    return function == SpecialFunction::LogGamma || function == SpecialFunction::Digamma ||
           function == SpecialFunction::BesselY || function == SpecialFunction::BesselK;
}

MpfrNumber value_of(SpecialFunction function, int order, const MpfrNumber& x) {
    MpfrNumber value;
    switch (function) {
        case SpecialFunction::Erf: mpfr_erf(value.get(), x.get(), MPFR_RNDN); break;
        case SpecialFunction::Erfc: mpfr_erfc(value.get(), x.get(), MPFR_RNDN); break;
        case SpecialFunction::ReciprocalGamma: return reciprocal_gamma(x);
        case SpecialFunction::LogGamma: mpfr_lngamma(value.get(), x.get(), MPFR_RNDN); break;
        case SpecialFunction::Digamma: mpfr_digamma(value.get(), x.get(), MPFR_RNDN); break;
        case SpecialFunction::ZetaTimes: return zeta_times(x);
        case SpecialFunction::LambertOfRoot: return lambert(x);
        case SpecialFunction::BesselJ: mpfr_jn(value.get(), order, x.get(), MPFR_RNDN); break;
        case SpecialFunction::BesselY: mpfr_yn(value.get(), order, x.get(), MPFR_RNDN); break;
        case SpecialFunction::BesselI: return modified_first(order, x);
        case SpecialFunction::BesselK: return modified_second(order, x);
    }
    return value;
}

}  // namespace

Reference special_reference(SpecialFunction function, int order, const MpfrNumber& x) {
    if (is_right_only(function) && x.sign() <= 0) return {};
    const bool grows = function == SpecialFunction::BesselI || function == SpecialFunction::BesselK;
    const double most = grows ? farthest_growing : farthest;
    const bool is_near = x < most && x > -most && (!is_right_only(function) || x > 1e-9);
    if (!is_near) return {.defined = true, .value = MpfrNumber(std::nan(""))};
    return {.defined = true, .value = value_of(function, order, x)};
}

Reference special_reference(const LineField& field, const MpfrNumber& x) {
    for (int f = 0; f <= static_cast<int>(SpecialFunction::BesselK); ++f) {
        const auto function = static_cast<SpecialFunction>(f);
        const int most = function < SpecialFunction::BesselJ ? 0 : highest_bessel_order;
        for (int order = 0; order <= most; ++order) {
            if (special_field(function, order).get() == &field)
                return special_reference(function, order, x);
        }
    }
    ADD_FAILURE() << "the reference does not know " << field.text();
    return {};
}

}  // namespace zeroset::test
