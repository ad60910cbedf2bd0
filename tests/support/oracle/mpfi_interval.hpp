#pragma once

#include <mpfi.h>
#include <mpfr.h>

#include <string>
#include <utility>

namespace zeroset::test {

/// Sets the precision, in bits, of the intervals that this thread makes while it lives.
class WorkingPrecision {
public:
    explicit WorkingPrecision(mpfr_prec_t bits) : saved_(mpfr_get_default_prec()) {
        mpfr_set_default_prec(bits);
    }
    ~WorkingPrecision() { mpfr_set_default_prec(saved_); }
    WorkingPrecision(const WorkingPrecision&) = delete;
    WorkingPrecision& operator=(const WorkingPrecision&) = delete;

private:
    mpfr_prec_t saved_;
};

/// An interval of MPFI in the working precision; every operation rounds outward. An operation
/// without a result (0 times the infinite end of an unbounded interval) gives the whole line. Use
/// it in round-to-nearest.
class MpfiInterval {
public:
    MpfiInterval() : MpfiInterval(0.0, 0.0) {}
    explicit MpfiInterval(double exact) : MpfiInterval(exact, exact) {}
    MpfiInterval(double lo, double hi) {
        mpfi_init(value_);
        mpfi_interv_d(value_, lo, hi);
    }
    MpfiInterval(const MpfiInterval& other) {
        mpfi_init(value_);
        mpfi_set(value_, other.value_);
    }
    /// Leaves `other` fit for assignment and destruction only.
    MpfiInterval(MpfiInterval&& other) noexcept { *value_ = std::exchange(*other.value_, {}); }
    MpfiInterval& operator=(MpfiInterval other) noexcept {
        std::swap(*value_, *other.value_);
        return *this;
    }
    ~MpfiInterval() {
        if (value_->left._mpfr_d != nullptr) mpfi_clear(value_);
    }
    static MpfiInterval whole_line();
    static MpfiInterval pi();

    [[nodiscard]] mpfi_ptr get() { return value_; }
    [[nodiscard]] mpfi_srcptr get() const { return value_; }
    [[nodiscard]] mpfr_ptr lo() { return &value_->left; }
    [[nodiscard]] mpfr_ptr hi() { return &value_->right; }
    [[nodiscard]] mpfr_srcptr lo() const { return &value_->left; }
    [[nodiscard]] mpfr_srcptr hi() const { return &value_->right; }

    [[nodiscard]] bool is_bounded() const { return mpfi_bounded_p(value_) != 0; }
    [[nodiscard]] bool contains_zero() const { return !is_above(0) && !is_below(0); }
    [[nodiscard]] bool is_zero() const { return mpfi_is_zero(value_) != 0; }
    /// Whether every number of the interval is above (below) `a`.
    [[nodiscard]] bool is_above(double a) const { return mpfr_cmp_d(lo(), a) > 0; }
    [[nodiscard]] bool is_below(double a) const { return mpfr_cmp_d(hi(), a) < 0; }
    [[nodiscard]] bool is_point() const { return mpfr_equal_p(lo(), hi()) != 0; }
    /// +1 or -1 where all numbers of the interval have that sign, else 0.
    [[nodiscard]] int sign() const { return is_above(0) ? 1 : is_below(0) ? -1 : 0; }
    /// The ends as doubles, rounded outward.
    [[nodiscard]] double lower() const { return mpfr_get_d(lo(), MPFR_RNDD); }
    [[nodiscard]] double upper() const { return mpfr_get_d(hi(), MPFR_RNDU); }
    [[nodiscard]] std::string text() const;

private:
    mpfi_t value_;
};

using MpfiFunction1 = int (*)(mpfi_ptr, mpfi_srcptr);
using MpfiFunction2 = int (*)(mpfi_ptr, mpfi_srcptr, mpfi_srcptr);

MpfiInterval computed(MpfiFunction1 function, const MpfiInterval& a);
MpfiInterval computed(MpfiFunction2 function, const MpfiInterval& a, const MpfiInterval& b);

MpfiInterval operator+(const MpfiInterval& a, const MpfiInterval& b);
MpfiInterval operator-(const MpfiInterval& a, const MpfiInterval& b);
MpfiInterval operator*(const MpfiInterval& a, const MpfiInterval& b);
/// a / b; the whole line where b contains 0.
MpfiInterval operator/(const MpfiInterval& a, const MpfiInterval& b);
MpfiInterval operator-(const MpfiInterval& a);
/// a^n, tight for even n; n >= 0.
MpfiInterval power(const MpfiInterval& a, int n);
/// The real n-th root, for odd n.
MpfiInterval odd_root(const MpfiInterval& a, int n);
MpfiInterval hull(const MpfiInterval& a, const MpfiInterval& b);
MpfiInterval minimum(const MpfiInterval& a, const MpfiInterval& b);
MpfiInterval maximum(const MpfiInterval& a, const MpfiInterval& b);
/// The range of an increasing function of MPFR that obeys its rounding mode.
template <class Function>
MpfiInterval increasing(Function function, const MpfiInterval& a) {
    MpfiInterval result;
    function(result.lo(), a.lo(), MPFR_RNDD);
    function(result.hi(), a.hi(), MPFR_RNDU);
    return result;
}

}  // namespace zeroset::test
