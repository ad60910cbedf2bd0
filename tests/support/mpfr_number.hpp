#pragma once

#include "engine/expr/expr.hpp"

#include <mpfr.h>

#include <array>
#include <cstddef>
#include <string>

namespace zeroset::test {

/// A number of 256 bits with a nearly unlimited exponent; each operation rounds to nearest. It is
/// wider than the types under test, and so never rounded to one of them. Use it in round-to-nearest
/// only.
class MpfrNumber {
public:
    static constexpr mpfr_prec_t precision_bits = 256;

    MpfrNumber() { mpfr_init2(value_, precision_bits); }
    explicit MpfrNumber(double exact) : MpfrNumber() { mpfr_set_d(value_, exact, MPFR_RNDN); }
    MpfrNumber(const MpfrNumber& other) : MpfrNumber() {
        mpfr_set(value_, other.value_, MPFR_RNDN);
    }
    MpfrNumber(MpfrNumber&& other) noexcept : MpfrNumber() { mpfr_swap(value_, other.value_); }
    MpfrNumber& operator=(MpfrNumber other) noexcept {
        mpfr_swap(value_, other.value_);
        return *this;
    }
    ~MpfrNumber() { mpfr_clear(value_); }

    [[nodiscard]] mpfr_ptr get() { return value_; }
    [[nodiscard]] mpfr_srcptr get() const { return value_; }

    [[nodiscard]] bool is_finite() const { return mpfr_number_p(value_) != 0; }
    [[nodiscard]] bool is_nan() const { return mpfr_nan_p(value_) != 0; }
    [[nodiscard]] int sign() const { return mpfr_sgn(value_); }
    /// The nearest double.
    [[nodiscard]] double nearest() const { return mpfr_get_d(value_, MPFR_RNDN); }
    /// The number in thirty digits.
    [[nodiscard]] std::string text() const;

private:
    mpfr_t value_;
};

MpfrNumber operator+(const MpfrNumber& a, const MpfrNumber& b);
MpfrNumber operator-(const MpfrNumber& a, const MpfrNumber& b);
MpfrNumber operator*(const MpfrNumber& a, const MpfrNumber& b);
MpfrNumber operator/(const MpfrNumber& a, const MpfrNumber& b);
MpfrNumber operator-(const MpfrNumber& a);
bool operator<(const MpfrNumber& a, double b);
bool operator>(const MpfrNumber& a, double b);
MpfrNumber pi();

/// The true value of a function at a point, as far as the reference knows it.
struct Reference {
    bool defined = false;
    MpfrNumber value;  ///< if defined; NaN where it is beyond the reach even of this type

    [[nodiscard]] bool is_unknown() const { return defined && value.is_nan(); }
};

/// The operator's value at its operands, of which those that it does not have are ignored; `n` is
/// the node's number. Angle is computed as atan2. Fails the running test for an unknown operator.
Reference reference(Op op, int n, const MpfrNumber& a, const MpfrNumber& b, const MpfrNumber& c);
inline Reference reference(Op op, int n, const MpfrNumber& a, const MpfrNumber& b) {
    return reference(op, n, a, b, b);
}

/// The formula's value at (x, y, z, w). A constant that is no double is taken as the middle of its
/// enclosure.
Reference reference(const Expr& expr, const std::array<MpfrNumber, 4>& at);
Reference reference(const Expr& expr, const std::array<double, 4>& at);

}  // namespace zeroset::test
