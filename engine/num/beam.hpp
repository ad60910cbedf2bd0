#pragma once

#include "engine/num/enclosure.hpp"

#include <array>
#include <optional>

// Beam forms: reduced affine arithmetic in three variables [ComSto93, Knoll09], over any carrier.
//   f(u, v, t) is in c + k[0] u + k[1] v + k[2] t + [-e, e]  for u, v, t in [-1, 1]
// The error e shrinks with the square of the cell, that of an interval with the cell.
//
// Differs from the papers:
// - The product keeps u^2, v^2 and t^2, which are never negative, in the middle of [0, 1].
// - Rounding: all of this runs in upward rounding, so e, made of sums and products of numbers that
//   are not negative, is an upper bound. The coefficients are rounded, and what that costs is
//   gathered in one number r for each form, in units of the format's rounding: an operator adds
//   the size of its result, and takes over the r of its operands by its derivatives. It bounds the
//   rounding of an evaluation at a point by the same formula as well, in the units of whatever
//   format that is made in.
// - A form with an infinite or NaN member is one of which nothing is known; see Beam::range.

namespace zeroset {

/// A form of which the rounding is in e already, or that has none.
template <class Real>
struct Affine {
    using Coefficients = std::array<std::optional<Real>, 3>;

    Real c;
    Coefficients k{};  ///< absent: 0
    Real e;            ///< not negative
};

/// The coefficients' error for an r of 1: each rounding is off by less than half `relative_gap`,
/// and an operator makes no more than three of its result's size.
template <class Real>
Real form_rounding(const Real& kind) {
    return like(kind, 1.5 * format_of(kind).relative_gap);
}

template <class Real>
void add_to(std::optional<Real>& sum, const Real& term) {
    sum = sum ? *sum + term : term;
}

/// The sum of |k|, rounded upward.
template <class Real>
std::optional<Real> spread_of_coefficients(const Affine<Real>& a) {
    std::optional<Real> sum;
    for (const std::optional<Real>& k : a.k) {
        if (k) add_to(sum, magnitude(*k));
    }
    return sum;
}

/// How far f is from c at most.
template <class Real>
Real deviation(const Affine<Real>& a) {
    const auto linear = spread_of_coefficients(a);
    return linear ? *linear + a.e : a.e;
}
/// An upper bound of |f|.
template <class Real>
Real largest(const Affine<Real>& a) {
    return magnitude(a.c) + deviation(a);
}

/// The middle of an interval, 0 for one without an end; and how far its ends are from it, +inf
/// where one is NaN.
template <class Real>
Affine<Real> centred(const Interval<Real>& a) {
    const Real far = like(a.hi, format_of(a.hi).largest_finite);
    const auto finite = both(a.neg_lo <= far, a.hi <= far);
    const Real half = like(a.hi, 0.5);
    const Real middle = a.hi * half - a.neg_lo * half;
    const Real c = select(finite, middle, like(a.hi, 0.0));
    return {c, {}, larger_bound(a.hi - c, a.neg_lo + c)};
}

template <class Real>
Affine<Real> operator-(const Affine<Real>& a) {
    Affine<Real> result{-a.c, {}, a.e};
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.k[i]) result.k[i] = -*a.k[i];
    }
    return result;
}

/// Without the rounding of the sum.
template <class Real>
Affine<Real> operator+(const Affine<Real>& a, const Affine<Real>& b) {
    Affine<Real> result{a.c + b.c, a.k, a.e + b.e};
    for (std::size_t i = 0; i < 3; ++i) {
        if (b.k[i]) add_to(result.k[i], *b.k[i]);
    }
    return result;
}

template <class Real>
Affine<Real> operator-(const Affine<Real>& a, const Affine<Real>& b) {
    return a + (-b);
}

/// The linear part of a product, without its rounding.
template <class Real>
void multiply_linear(const Affine<Real>& a, const Affine<Real>& b, Affine<Real>& result) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.k[i]) result.k[i] = *a.k[i] * b.c;
        if (!b.k[i]) continue;
        result.k[i] = result.k[i] ? fused(a.c, *b.k[i], *result.k[i]) : a.c * *b.k[i];
    }
}

/// The product of forms that deviate by no more than `da` and `db` from their middles, without its
/// rounding.
template <class Real>
Affine<Real> product(const Affine<Real>& a, const Real& da, const Affine<Real>& b, const Real& db) {
    Affine<Real> result{
        a.c * b.c, {}, fused(magnitude(a.c), b.e, fused(magnitude(b.c), a.e, da * db))};
    multiply_linear(a, b, result);
    return result;
}

/// The same, where equal variables make the error smaller: their squares are never negative.
template <class Real>
Affine<Real> centred_product(const Affine<Real>& a, const Real& da, const Affine<Real>& b,
                             const Real& db) {
    Affine<Real> result = product(a, da, b, db);
    std::optional<Real> sum;
    std::optional<Real> sizes;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!a.k[i] || !b.k[i]) continue;
        const Real square = *a.k[i] * *b.k[i];
        add_to(sum, square);
        add_to(sizes, magnitude(square));
    }
    if (!sum) return result;
    result.c = fused(*sum, like(a.c, 0.5), result.c);
    // Five roundings, each of half the gap.
    const double half = 0.5 * (1.0 - 4 * format_of(a.c).relative_gap);
    result.e = fused(*sizes, like(a.c, -half), result.e);
    return result;
}

/// a * factor + [-e, e], without its rounding.
template <class Real>
Affine<Real> scaled(const Affine<Real>& a, const Real& factor) {
    Affine<Real> result{a.c * factor, {}, a.e * magnitude(factor)};
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.k[i]) result.k[i] = *a.k[i] * factor;
    }
    return result;
}

/// A form with its rounding apart.
template <class Real>
struct Beam {
    Beam() = default;
    Beam(const Affine<Real>& form, const Real& rounding, const Real& bound)
        : f(form), r(rounding), size(bound) {}

    Affine<Real> f;
    /// The coefficients are off by no more than `form_rounding` r in sum; an evaluation at a point,
    /// each operation of which is off by less than u times its result, by u r, but for terms of
    /// u^2.
    Real r;
    Real size;  ///< an upper bound of |f|, not a tight one

    /// e with all roundings.
    const Real& error() const {
        if (!error_) error_ = fused(r, form_rounding(r), f.e);
        return *error_;
    }
    /// How far the function is from c at most, with all roundings.
    const Real& spread() const {
        if (!spread_) {
            const auto linear = spread_of_coefficients(f);
            spread_ = linear ? *linear + error() : error();
        }
        return *spread_;
    }
    /// An upper bound of |f|, a tight one.
    const Real& largest() const {
        if (!largest_) largest_ = magnitude(f.c) + spread();
        return *largest_;
    }
    /// The whole line where nothing is known.
    [[nodiscard]] Interval<Real> range() const {
        return without_nan(Interval<Real>{spread() - f.c, f.c + spread()});
    }

private:
    // Kept, as machine code would compute them again.
    mutable std::optional<Real> error_{}, spread_{}, largest_{};
};

template <class Real>
Beam<Real> operator-(const Beam<Real>& a) {
    return {-a.f, a.r, a.size};
}

template <class Real>
Beam<Real> operator+(const Beam<Real>& a, const Beam<Real>& b) {
    const Real size = a.size + b.size;
    return {a.f + b.f, a.r + b.r + size, size};
}

template <class Real>
Beam<Real> operator-(const Beam<Real>& a, const Beam<Real>& b) {
    return a + (-b);
}

/// An upper bound of |a b|, and of the rounding of a product so small that it loses digits.
template <class Real>
Real product_size(const Real& a, const Real& b) {
    return fused(a, b, like(a, format_of(a).smallest_normal));
}

template <class Real>
Beam<Real> operator*(const Beam<Real>& a, const Beam<Real>& b) {
    const Real& size_a = a.largest();
    const Real& size_b = b.largest();
    const Real size = product_size(size_a, size_b);
    return {centred_product(a.f, a.spread(), b.f, b.spread()),
            fused(size_a, b.r, fused(size_b, a.r, size)), size};
}

/// a * c for the exact number c, a number of the format.
template <class Real>
Beam<Real> scale(const Beam<Real>& a, double c) {
    const Real factor = like(a.r, c);
    const Real size = product_size(a.size, magnitude(factor));
    return {scaled(a.f, factor), fused(a.r, magnitude(factor), size), size};
}

/// For a = c + d, d^2 is in [0, |d|^2].
template <class Real>
Beam<Real> square(const Beam<Real>& a) {
    const Real& d = a.spread();
    const Real half_square = like(d, 0.5) * d * d;
    Affine<Real> f = scaled(a.f, a.f.c + a.f.c);
    f.c = fused(a.f.c, a.f.c, half_square);
    f.e = f.e + half_square;
    const Real& size_a = a.largest();
    const Real size = product_size(size_a, size_a);
    return {f, fused(size_a + size_a, a.r, size), size};
}

/// For a = c + d with |d| <= q, d^2 is in [0, q^2] and d^3 in 3/4 q^2 d + [-1/4, 1/4] q^3.
template <class Real>
Beam<Real> cube(const Beam<Real>& a) {
    const auto number = [&](double x) { return like(a.r, x); };
    const Real& c = a.f.c;
    const Real& q = a.spread();
    const Real q2 = q * q;
    const Real c2 = c * c;
    Affine<Real> f = scaled(a.f, number(3) * c2 + number(0.75) * q2);
    f.c = c * (c2 + number(1.5) * q2);
    f.e = f.e + number(1.5) * magnitude(c) * q2 + number(0.25) * q2 * q;
    const Real& size_a = a.largest();
    const Real size2 = size_a * size_a;
    const Real size = product_size(size2, size_a);
    return {f, number(3) * size2 * a.r + number(4) * size, size};
}

/// A form all of whose roundings are in e: of a derivative, which is never evaluated at a point.
template <class Real>
struct SlopeBeam {
    Affine<Real> f;
    Real size;  ///< an upper bound of |f|, not a tight one

    [[nodiscard]] Interval<Real> range() const {
        const Real spread = deviation(f);
        return without_nan(Interval<Real>{spread - f.c, f.c + spread});
    }
};

/// With the rounding of an operator's result.
template <class Real>
SlopeBeam<Real> rounded(Affine<Real> f, const Real& size) {
    f.e = fused(size, form_rounding(size), f.e);
    return {f, size};
}

/// All of the beam's roundings.
template <class Real>
SlopeBeam<Real> slope_beam(const Beam<Real>& a) {
    Affine<Real> f = a.f;
    f.e = a.error();
    return {f, a.size};
}

template <class Real>
SlopeBeam<Real> operator-(const SlopeBeam<Real>& a) {
    return {-a.f, a.size};
}

template <class Real>
SlopeBeam<Real> operator+(const SlopeBeam<Real>& a, const SlopeBeam<Real>& b) {
    return rounded(a.f + b.f, a.size + b.size);
}

template <class Real>
SlopeBeam<Real> operator*(const Beam<Real>& a, const SlopeBeam<Real>& b) {
    Affine<Real> factor = a.f;
    factor.e = a.error();
    const Real spread_b = deviation(b.f);
    return rounded(product(factor, a.spread(), b.f, spread_b),
                   product_size(a.largest(), magnitude(b.f.c) + spread_b));
}

template <class Real>
SlopeBeam<Real> scale(const SlopeBeam<Real>& a, double c) {
    const Real factor = like(a.size, c);
    return rounded(scaled(a.f, factor), product_size(a.size, magnitude(factor)));
}

/// a^n for n >= 1.
template <class Real>
Beam<Real> power(const Beam<Real>& a, int n) {
    if (n == 1) return a;
    if (n == 3) return cube(a);
    if (n % 2 == 0) return power(square(a), n / 2);
    return power(a, n - 1) * a;
}

}  // namespace zeroset
