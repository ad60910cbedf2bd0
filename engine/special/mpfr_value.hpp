#pragma once

#include <mpfr.h>

namespace zeroset {

/// A number of MPFR that frees itself.
class MpfrValue {
public:
    explicit MpfrValue(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
    MpfrValue(mpfr_prec_t bits, double number) : MpfrValue(bits) {
        mpfr_set_d(value_, number, MPFR_RNDN);
    }
    ~MpfrValue() { mpfr_clear(value_); }
    MpfrValue(const MpfrValue&) = delete;
    MpfrValue& operator=(const MpfrValue&) = delete;

    // NOLINTNEXTLINE(google-explicit-constructor): functions of MPFR take its pointers
    operator mpfr_ptr() { return value_; }
    // NOLINTNEXTLINE(google-explicit-constructor)
    operator mpfr_srcptr() const { return value_; }

private:
    mpfr_t value_;
};

}  // namespace zeroset
