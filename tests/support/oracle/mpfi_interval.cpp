#include "tests/support/oracle/mpfi_interval.hpp"

#include <limits>

namespace zeroset::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void widen_nan(MpfiInterval& a) {
    if (mpfi_nan_p(a.get()) != 0) mpfi_interv_d(a.get(), -infinity, infinity);
}

}  // namespace

MpfiInterval MpfiInterval::whole_line() { return {-infinity, infinity}; }

MpfiInterval MpfiInterval::pi() {
    MpfiInterval result;
    mpfi_const_pi(result.get());
    return result;
}

std::string MpfiInterval::text() const {
    char* text = nullptr;
    mpfr_asprintf(&text, "[%.25RDg, %.25RUg]", lo(), hi());
    std::string result(text);
    mpfr_free_str(text);
    return result;
}

MpfiInterval computed(MpfiFunction1 function, const MpfiInterval& a) {
    MpfiInterval result;
    function(result.get(), a.get());
    widen_nan(result);
    return result;
}

MpfiInterval computed(MpfiFunction2 function, const MpfiInterval& a, const MpfiInterval& b) {
    MpfiInterval result;
    function(result.get(), a.get(), b.get());
    widen_nan(result);
    return result;
}

MpfiInterval operator+(const MpfiInterval& a, const MpfiInterval& b) {
    return computed(mpfi_add, a, b);
}
MpfiInterval operator-(const MpfiInterval& a, const MpfiInterval& b) {
    return computed(mpfi_sub, a, b);
}
MpfiInterval operator*(const MpfiInterval& a, const MpfiInterval& b) {
    return computed(mpfi_mul, a, b);
}
MpfiInterval operator/(const MpfiInterval& a, const MpfiInterval& b) {
    return b.contains_zero() ? MpfiInterval::whole_line() : computed(mpfi_div, a, b);
}
MpfiInterval operator-(const MpfiInterval& a) { return computed(mpfi_neg, a); }

MpfiInterval power(const MpfiInterval& a, int n) {
    const auto exponent = static_cast<unsigned long>(n);
    const auto raise = [exponent](mpfr_ptr out, mpfr_srcptr in, mpfr_rnd_t mode) {
        return mpfr_pow_ui(out, in, exponent, mode);
    };
    return increasing(raise, n % 2 == 0 ? computed(mpfi_abs, a) : a);
}

MpfiInterval odd_root(const MpfiInterval& a, int n) {
    const auto degree = static_cast<unsigned long>(n);
    return increasing([degree](mpfr_ptr out, mpfr_srcptr in,
                               mpfr_rnd_t mode) { return mpfr_rootn_ui(out, in, degree, mode); },
                      a);
}

MpfiInterval hull(const MpfiInterval& a, const MpfiInterval& b) {
    return computed(mpfi_union, a, b);
}

MpfiInterval minimum(const MpfiInterval& a, const MpfiInterval& b) {
    MpfiInterval result;
    mpfr_min(result.lo(), a.lo(), b.lo(), MPFR_RNDD);
    mpfr_min(result.hi(), a.hi(), b.hi(), MPFR_RNDU);
    return result;
}
MpfiInterval maximum(const MpfiInterval& a, const MpfiInterval& b) {
    MpfiInterval result;
    mpfr_max(result.lo(), a.lo(), b.lo(), MPFR_RNDD);
    mpfr_max(result.hi(), a.hi(), b.hi(), MPFR_RNDU);
    return result;
}

}  // namespace zeroset::test
