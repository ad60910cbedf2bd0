#pragma once

#include "engine/real/scalar.hpp"

// Directions as complex numbers of absolute value 1, over any carrier. Not rounded outward.

namespace zeroset {

template <class Real>
struct Complex {
    Real re, im;
};

template <class Real>
Complex<Real> operator*(const Complex<Real>& a, const Complex<Real>& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

template <class Real>
Complex<Real> square(const Complex<Real>& a) {
    return {a.re * a.re - a.im * a.im, (a.re + a.re) * a.im};
}

/// a^n for n >= 1.
template <class Real>
Complex<Real> power(const Complex<Real>& a, int n) {
    if (n == 1) return a;
    if (n % 2 == 0) return square(power(a, n / 2));
    return power(a, n - 1) * a;
}

/// The point x + iy = length (direction.re + i direction.im).
template <class Real>
struct PolarPoint {
    Real square;              ///< length^2
    Real length, per_length;  ///< length, 1 / length
    Complex<Real> direction;
};

/// The point (x, y) in polar form. Where `square` is a normal number, length is off by less than 3
/// units, per_length by 4, and the members of direction by 5.
template <class Real>
PolarPoint<Real> polar_point(const Real& y, const Real& x) {
    const Real square = x * x + y * y;
    const Real length = square_root(square);
    const Real per_length = like(length, 1.0) / length;
    return {square, length, per_length, {x * per_length, y * per_length}};
}

/// Error bound, in units, of the n-th power of a polar_point's direction: each of its n factors is
/// off by 5, each product by 2.5.
constexpr double power_error(int n) { return 7.5 * n; }

}  // namespace zeroset
