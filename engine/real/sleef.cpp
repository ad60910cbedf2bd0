#include "engine/real/sleef.hpp"

#include "engine/real/processor.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/sleef_lanes.hpp"

#include <mpfr.h>

#include <bit>
#include <limits>

namespace zeroset {
namespace {

/// An MPFR number with the precision of double.
struct DoubleNumber {
    mpfr_t value;

    explicit DoubleNumber(double number) {
        mpfr_init2(value, std::numeric_limits<double>::digits);
        mpfr_set_d(value, number, MPFR_RNDN);
    }
    DoubleNumber(const DoubleNumber&) = delete;
    DoubleNumber& operator=(const DoubleNumber&) = delete;
    ~DoubleNumber() { mpfr_clear(value); }
};

/// Gives this thread's MPFR numbers the exponents of double, denormals included, while it lives.
class DoubleExponents {
public:
    DoubleExponents() {
        mpfr_set_emin(-1073);  // MPFR's significands are below 1: 2^-1074 is 0.5 * 2^-1073
        mpfr_set_emax(1024);
    }
    ~DoubleExponents() {
        mpfr_set_emin(emin_);
        mpfr_set_emax(emax_);
        mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);  // which would leak at the end of a thread
    }
    DoubleExponents(const DoubleExponents&) = delete;
    DoubleExponents& operator=(const DoubleExponents&) = delete;

private:
    mpfr_exp_t emin_ = mpfr_get_emin();
    mpfr_exp_t emax_ = mpfr_get_emax();
};

template <int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t)>
int call(mpfr_ptr result, mpfr_srcptr a, mpfr_srcptr /*b*/) {
    return function(result, a, MPFR_RNDN);
}
template <int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t)>
int call(mpfr_ptr result, mpfr_srcptr a, mpfr_srcptr b) {
    return function(result, a, b, MPFR_RNDN);
}

/// Writes the function's value and returns MPFR's ternary value.
int computed(Elementary function, mpfr_ptr result, mpfr_srcptr a, mpfr_srcptr b) {
    switch (function) {
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    case Elementary::id: return call<mpfr_##name>(result, a, b);
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
    }
    return 0;
}

/// Code over a register of `bits` bits, or over a plain number for 0; nullptr where there is none.
template <class Real>
const void* code_of_width(Elementary function, int bits) {
    // SLEEF's "finz" functions (with fused multiply-add) give the same bits at every width, and so
    // do its "cinz" ones over registers, of which sleef_plain takes a lane; the machine decides the
    // family once for all widths.
    static const bool fma = machine_has_avx2_fma();
    switch (bits) {
        case 0: return fma ? sleef_fma<Real>(function) : sleef_plain<Real>(function);
        case 128: return fma ? sleef_avx2_128<Real>(function) : sleef_sse2<Real>(function);
        case 256: return fma ? sleef_avx2_256<Real>(function) : nullptr;
        case 512: return machine_has_avx512() ? sleef_avx512<Real>(function) : nullptr;
        default: return nullptr;
    }
}

template <class Real>
Real one_lane_of(Elementary function, Real a, Real b) {
    const UpwardRounding upward;  // the code returns in this mode; the guard restores the caller's
    const void* const code = code_of_width<Real>(function, 0);
    if (elementary_arity(function) == 1) return std::bit_cast<Real (*)(Real)>(code)(a);
    return std::bit_cast<Real (*)(Real, Real)>(code)(a, b);
}

}  // namespace

const void* elementary_code(Elementary function, int lanes, RealType type) {
    if (lanes < 1 || lanes > 16) return nullptr;
    const bool is_float = type == RealType::Float;
    const int bits = lanes == 1 ? 0 : lanes * (is_float ? 32 : 64);
    return is_float ? code_of_width<float>(function, bits) : code_of_width<double>(function, bits);
}

float one_lane(Elementary function, float a, float b) { return one_lane_of(function, a, b); }
double one_lane(Elementary function, double a, double b) { return one_lane_of(function, a, b); }

double correctly_rounded(Elementary function, double a, double b) {
    const NearestRounding nearest;
    const DoubleExponents exponents;
    const DoubleNumber x(a);
    const DoubleNumber y(b);
    DoubleNumber result(0.0);
    const int rounded = computed(function, result.value, x.value, y.value);
    mpfr_subnormalize(result.value, rounded, MPFR_RNDN);
    return mpfr_get_d(result.value, MPFR_RNDN);
}

}  // namespace zeroset
