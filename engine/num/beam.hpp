#pragma once

#include "engine/num/enclosure.hpp"

#include <array>
#include <optional>

// Beam forms: reduced affine arithmetic in three variables [ComSto93, Knoll09], over any carrier.
//   f(u, v, t) is in c + k[0] u + k[1] v + k[2] t + [-e, e]  for u, v, t in [-1, 1]
// The error e shrinks with the square of the cell's size, that of an interval with the size.
//
// Differs from the papers:
// - The product encloses u^2, v^2 and t^2, which are never negative, in 1/2 + [-1/2, 1/2].
// - Rounding: everything here runs in upward rounding, so e, made of sums and products of
//   nonnegative numbers, is an upper bound. The rounding errors of the coefficients are gathered in
//   one number r for each form, in units of the format's rounding: the r of an operator's result is
//   the size of the result plus the r of each operand times a bound of the derivative by it. This
//   r also bounds the rounding error of evaluating the same formula at a point, in units of the
//   format of that evaluation.
// - Nothing is known of f where a member of its form is infinite or NaN; see Beam::range.

namespace zeroset {

/// A form whose rounding errors are part of e, are bounded elsewhere (Beam::r), or do not exist.
template <class Real>
struct Affine {
    using Coefficients = std::array<std::optional<Real>, 3>;

    Real c;
    Coefficients k{};  ///< absent: 0
    Real e;            ///< not negative
};

/// Error of the coefficients for r = 1: each rounding is off by less than half `relative_gap`, and
/// an operator makes at most three roundings of numbers as large as its result.
template <class Real>
Real form_rounding(const Real& kind) {
    return like(kind, 1.5 * format_of(kind).relative_gap);
}

template <class Real>
void add_to(std::optional<Real>& sum, const Real& term) {
    sum = sum ? *sum + term : term;
}

/// Sum of |k[i]|, rounded upward; absent if all k[i] are.
template <class Real>
std::optional<Real> spread_of_coefficients(const Affine<Real>& a) {
    std::optional<Real> sum;
    for (const std::optional<Real>& k : a.k) {
        if (k) add_to(sum, magnitude(*k));
    }
    return sum;
}

/// Upper bound of |f - c|.
template <class Real>
Real deviation(const Affine<Real>& a) {
    const auto linear = spread_of_coefficients(a);
    return linear ? *linear + a.e : a.e;
}
/// Upper bound of |f|.
template <class Real>
Real largest(const Affine<Real>& a) {
    return magnitude(a.c) + deviation(a);
}

/// The interval as a form: c is its midpoint, 0 where an end is infinite or NaN; e is the distance
/// from c to the farther end, +inf where an end is NaN.
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

/// a + b, without the rounding errors of the sum.
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

/// Sets result.k to the linear part of a b, without its rounding errors.
template <class Real>
void multiply_linear(const Affine<Real>& a, const Affine<Real>& b, Affine<Real>& result) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.k[i]) result.k[i] = *a.k[i] * b.c;
        if (!b.k[i]) continue;
        result.k[i] = result.k[i] ? fused(a.c, *b.k[i], *result.k[i]) : a.c * *b.k[i];
    }
}

/// a b, where |a - a.c| <= da and |b - b.c| <= db, without the rounding errors of the coefficients.
template <class Real>
Affine<Real> product(const Affine<Real>& a, const Real& da, const Affine<Real>& b, const Real& db) {
    Affine<Real> result{
        a.c * b.c, {}, fused(magnitude(a.c), b.e, fused(magnitude(b.c), a.e, da * db))};
    multiply_linear(a, b, result);
    return result;
}

/// a b, as `product`, with a smaller error where a and b share a variable: its square is in [0, 1].
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
    // `half` is below 1/2 by more than five relative rounding errors of relative_gap / 2.
    const double half = 0.5 * (1.0 - 4 * format_of(a.c).relative_gap);
    result.e = fused(*sizes, like(a.c, -half), result.e);
    return result;
}

/// a * factor, without the rounding errors of the coefficients.
template <class Real>
Affine<Real> scaled(const Affine<Real>& a, const Real& factor) {
    Affine<Real> result{a.c * factor, {}, a.e * magnitude(factor)};
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.k[i]) result.k[i] = *a.k[i] * factor;
    }
    return result;
}

/// A form with its rounding errors kept in r, apart from e.
template <class Real>
struct Beam {
    Beam() = default;
    Beam(const Affine<Real>& form, const Real& rounding, const Real& bound)
        : f(form), r(rounding), size(bound) {}

    Affine<Real> f;
    /// Rounding errors, in units: the coefficients together are off by at most form_rounding * r;
    /// an evaluation at a point whose operations have relative errors below u is off by at most
    /// u r, up to terms of u^2.
    Real r;
    Real size;  ///< upper bound of |f|, not tight

    /// e plus the rounding errors of the coefficients.
    const Real& error() const {
        if (!error_) error_ = fused(r, form_rounding(r), f.e);
        return *error_;
    }
    /// Upper bound of |f - c|, rounding errors included.
    const Real& spread() const {
        if (!spread_) {
            const auto linear = spread_of_coefficients(f);
            spread_ = linear ? *linear + error() : error();
        }
        return *spread_;
    }
    /// Tight upper bound of |f|, rounding errors included.
    const Real& largest() const {
        if (!largest_) largest_ = magnitude(f.c) + spread();
        return *largest_;
    }
    /// Encloses f over the cell; the whole line where nothing is known.
    [[nodiscard]] Interval<Real> range() const {
        return without_nan(Interval<Real>{spread() - f.c, f.c + spread()});
    }

private:
    // Cached: where Real builds machine code, each use would emit their computation again.
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

/// Upper bound of |a b| that also covers the rounding error of a product below the normal range.
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

/// a * c for an exact number c of the format.
template <class Real>
Beam<Real> scale(const Beam<Real>& a, double c) {
    const Real factor = like(a.r, c);
    const Real size = product_size(a.size, magnitude(factor));
    return {scaled(a.f, factor), fused(a.r, magnitude(factor), size), size};
}

/// a^2: with a = c + d, d^2 is in [0, spread^2].
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

/// a^3: with a = c + d and |d| <= q, d^2 is in [0, q^2] and d^3 in 3/4 q^2 d + [-1/4, 1/4] q^3.
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

/// Form of a derivative. It is never evaluated at a point, so e holds all rounding errors.
template <class Real>
struct SlopeBeam {
    Affine<Real> f;
    Real size;  ///< upper bound of |f|, not tight

    [[nodiscard]] Interval<Real> range() const {
        const Real spread = deviation(f);
        return without_nan(Interval<Real>{spread - f.c, f.c + spread});
    }
};

/// `f` with the rounding error of one operator added to e; `size` bounds the operator's result.
template <class Real>
SlopeBeam<Real> rounded(Affine<Real> f, const Real& size) {
    f.e = fused(size, form_rounding(size), f.e);
    return {f, size};
}

/// `a` with all its rounding errors moved into e.
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
