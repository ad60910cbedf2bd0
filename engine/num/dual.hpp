#pragma once

#include "engine/num/scalar.hpp"
#include "engine/num/sleef.hpp"

#include <array>
#include <optional>

// Value and gradient by forward differentiation, over any carrier. Not rounded outward.

namespace zeroset {

/// f and df/dx, df/dy, df/dz; an absent derivative is 0 for every point.
template <class Real>
struct Dual {
    Real value;
    std::array<std::optional<Real>, 3> slope;
};

namespace detail {

template <class Real>
std::optional<Real> sum(const std::optional<Real>& a, const std::optional<Real>& b) {
    if (!a) return b;
    if (!b) return a;
    return *a + *b;
}

template <class Real>
std::optional<Real> product(const Real& a, const std::optional<Real>& b) {
    if (!b) return std::nullopt;
    return a * *b;
}

}  // namespace detail

/// g(a) from its value and g'(a).
template <class Real>
Dual<Real> chain(const Real& value, const Real& derivative, const Dual<Real>& a) {
    Dual<Real> result{value, {}};
    for (std::size_t i = 0; i < 3; ++i)
        result.slope[i] = detail::product(derivative, a.slope[i]);
    return result;
}

/// g(a, b) from its value and its partial derivatives.
template <class Real>
Dual<Real> chain(const Real& value, const Real& by_a, const Dual<Real>& a, const Real& by_b,
                 const Dual<Real>& b) {
    Dual<Real> result{value, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        result.slope[i] =
            detail::sum(detail::product(by_a, a.slope[i]), detail::product(by_b, b.slope[i]));
    }
    return result;
}

template <class Real>
Dual<Real> operator-(const Dual<Real>& a) {
    Dual<Real> result{-a.value, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.slope[i]) result.slope[i] = -*a.slope[i];
    }
    return result;
}

template <class Real>
Dual<Real> operator+(const Dual<Real>& a, const Dual<Real>& b) {
    Dual<Real> result{a.value + b.value, {}};
    for (std::size_t i = 0; i < 3; ++i)
        result.slope[i] = detail::sum(a.slope[i], b.slope[i]);
    return result;
}

template <class Real>
Dual<Real> operator-(const Dual<Real>& a, const Dual<Real>& b) {
    Dual<Real> result = a + (-b);
    result.value = a.value - b.value;
    return result;
}

template <class Real>
Dual<Real> operator*(const Dual<Real>& a, const Dual<Real>& b) {
    return chain(a.value * b.value, b.value, a, a.value, b);
}

template <class Real>
Dual<Real> operator/(const Dual<Real>& a, const Dual<Real>& b) {
    const Real reciprocal = like(b.value, 1.0) / b.value;
    const Real quotient = a.value / b.value;
    return chain(quotient, reciprocal, a, -(quotient * reciprocal), b);
}

template <class Real>
Real point_power(const Real& a, int n) {
    if (n == 1) return a;
    const Real half = point_power(a * a, n / 2);
    return n % 2 == 0 ? half : half * a;
}

/// a^n for n >= 2.
template <class Real>
Dual<Real> power(const Dual<Real>& a, int n) {
    const Real below = point_power(a.value, n - 1);
    return chain(below * a.value, below * like(a.value, n), a);
}

template <class Real>
Dual<Real> sqrt(const Dual<Real>& a) {
    const Real root = square_root(a.value);
    return chain(root, like(root, 0.5) / root, a);
}

template <class Real>
Dual<Real> abs(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    return chain(magnitude(a.value), select_negative(a.value, -one, one), a);
}

template <class Real>
Dual<Real> sin(const Dual<Real>& a) {
    return chain(elementary(Elementary::Sin, a.value), elementary(Elementary::Cos, a.value), a);
}

template <class Real>
Dual<Real> cos(const Dual<Real>& a) {
    return chain(elementary(Elementary::Cos, a.value), -elementary(Elementary::Sin, a.value), a);
}

template <class Real>
Dual<Real> acos(const Dual<Real>& a) {
    const Real one = like(a.value, 1.0);
    const Real slope = -(one / square_root((one - a.value) * (one + a.value)));
    return chain(elementary(Elementary::Acos, a.value), slope, a);
}

template <class Real>
Dual<Real> exp(const Dual<Real>& a) {
    const Real value = elementary(Elementary::Exp, a.value);
    return chain(value, value, a);
}

template <class Real>
Dual<Real> log(const Dual<Real>& a) {
    return chain(elementary(Elementary::Log, a.value), like(a.value, 1.0) / a.value, a);
}

template <class Real>
Dual<Real> atan2(const Dual<Real>& y, const Dual<Real>& x) {
    const Real radius2 = x.value * x.value + y.value * y.value;
    return chain(elementary(Elementary::Atan2, y.value, x.value), x.value / radius2, y,
                 -(y.value / radius2), x);
}

template <class Mask, class Real>
Dual<Real> select_dual(const Mask& condition, const Dual<Real>& a, const Dual<Real>& b) {
    Dual<Real> result{select(condition, a.value, b.value), {}};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!a.slope[i] && !b.slope[i]) continue;
        const Real zero = like(a.value, 0.0);
        result.slope[i] = select(condition, a.slope[i].value_or(zero), b.slope[i].value_or(zero));
    }
    return result;
}

template <class Real>
Dual<Real> min(const Dual<Real>& a, const Dual<Real>& b) {
    return select_dual(a.value < b.value, a, b);
}

template <class Real>
Dual<Real> max(const Dual<Real>& a, const Dual<Real>& b) {
    return select_dual(a.value > b.value, a, b);
}

}  // namespace zeroset
