#pragma once

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

// Owners of FLINT's numbers and polynomials.

namespace zeroset::test {

class FlintInteger {
public:
    FlintInteger() { fmpz_init(value_); }
    FlintInteger(const FlintInteger& other) { fmpz_init_set(value_, other.value_); }
    FlintInteger& operator=(FlintInteger other) noexcept {
        fmpz_swap(value_, other.value_);
        return *this;
    }
    ~FlintInteger() { fmpz_clear(value_); }
    [[nodiscard]] fmpz* get() { return value_; }
    [[nodiscard]] const fmpz* get() const { return value_; }

private:
    fmpz_t value_;
};

class FlintRational {
public:
    FlintRational() { fmpq_init(value_); }
    /// The double's exact value.
    explicit FlintRational(double exact);
    FlintRational(const FlintRational& other) : FlintRational() { fmpq_set(value_, other.value_); }
    FlintRational& operator=(FlintRational other) noexcept {
        fmpq_swap(value_, other.value_);
        return *this;
    }
    ~FlintRational() { fmpq_clear(value_); }
    [[nodiscard]] fmpq* get() { return value_; }
    [[nodiscard]] const fmpq* get() const { return value_; }

private:
    fmpq_t value_;
};

/// A polynomial with rational coefficients.
class RationalPolynomial {
public:
    RationalPolynomial() { fmpq_poly_init(value_); }
    RationalPolynomial(const RationalPolynomial& other) : RationalPolynomial() {
        fmpq_poly_set(value_, other.value_);
    }
    RationalPolynomial& operator=(RationalPolynomial other) noexcept {
        fmpq_poly_swap(value_, other.value_);
        return *this;
    }
    ~RationalPolynomial() { fmpq_poly_clear(value_); }
    /// The polynomial first + second t.
    static RationalPolynomial linear(const FlintRational& first, const FlintRational& second);
    [[nodiscard]] fmpq_poly_struct* get() { return value_; }
    [[nodiscard]] const fmpq_poly_struct* get() const { return value_; }
    [[nodiscard]] bool is_number() const { return fmpq_poly_degree(value_) <= 0; }
    [[nodiscard]] bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }

private:
    fmpq_poly_t value_;
};

/// A polynomial with integer coefficients.
class IntegerPolynomial {
public:
    IntegerPolynomial() { fmpz_poly_init(value_); }
    IntegerPolynomial(const IntegerPolynomial& other) : IntegerPolynomial() {
        fmpz_poly_set(value_, other.value_);
    }
    IntegerPolynomial& operator=(IntegerPolynomial other) noexcept {
        fmpz_poly_swap(value_, other.value_);
        return *this;
    }
    ~IntegerPolynomial() { fmpz_poly_clear(value_); }
    [[nodiscard]] fmpz_poly_struct* get() { return value_; }
    [[nodiscard]] const fmpz_poly_struct* get() const { return value_; }
    [[nodiscard]] long degree() const { return fmpz_poly_degree(value_); }

private:
    fmpz_poly_t value_;
};

}  // namespace zeroset::test
