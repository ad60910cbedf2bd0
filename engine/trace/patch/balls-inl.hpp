// Balls of real numbers, and vectors and matrices of two rows, over a carrier: float, double or
// Highway's vectors of them. Included once for each instruction set, after Highway.
//
// All of this must run in upward rounding. There a result is off by less than u of its size, or by
// less than the least number, d, where it is smaller than normal ones:
//   u = 2^-52, d = 2^-1074 in double;   u = 2^-23, d = 2^-149 in float.
// Sums and products that overflow are +inf, and those below 0 the finite number of largest size.

#if defined(ZEROSET_BALLS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BALLS_INL
#undef ZEROSET_BALLS_INL
#else
#define ZEROSET_BALLS_INL
#endif

#include "engine/real/lane_carrier-inl.hpp"
#include "engine/trace/patch/matrix2.hpp"

#include <hwy/highway.h>

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A type of numbers, as far as the proofs below go by it.
struct BallFormat {
    double rounding;           ///< at least 8 u
    double least;              ///< at least 2^8 d
    double most;               ///< 1 / rounding times this is finite
    double safe;               ///< of determinants: 2^9 roundings at least
    double safe_growth;        ///< 1 + 2 rounding / safe at least
    double least_determinant;  ///< far above d
    double most_determinant;   ///< far below the largest number
    double least_place;        ///< 2^8 d / least_determinant at least
};
template <class Number>
constexpr BallFormat format_of_balls{};
template <>
constexpr BallFormat format_of_balls<double>{.rounding = 0x1p-46,
                                             .least = 0x1p-1060,
                                             .most = 0x1p970,
                                             .safe = 0x1p-30,
                                             .safe_growth = 1.0 + 0x1p-10,
                                             .least_determinant = 0x1p-900,
                                             .most_determinant = 0x1p1000,
                                             .least_place = 0x1p-150};
template <>
constexpr BallFormat format_of_balls<float>{.rounding = 0x1p-20,
                                            .least = 0x1p-140,
                                            .most = 0x1p100,
                                            .safe = 0x1p-10,
                                            .safe_growth = 1.0 + 0x1p-8,
                                            .least_determinant = 0x1p-80,
                                            .most_determinant = 0x1p120,
                                            .least_place = 0x1p-60};
template <class Real>
constexpr BallFormat balls = format_of_balls<typename NumberOf<Real>::Type>;

// RealBall: the ball of each operation holds the exact results for all numbers of its operands'
// balls. Its radius is what theirs make, a sum of products of numbers >= 0 that is rounded upward,
// and so never too small; and `rounding` times the sizes of the terms and `least`, more than eight
// roundings take from these, each u of a term or d.
// A term is at most 1 / `rounding` times the radius that it goes into. So no term has overflowed
// where the radius is below `most`: a ball says something where its middle and radius and those of
// the balls that it was made of are. A NaN in an operand makes one of the radius or of the middle.

/// The ball of a result that was computed of terms whose sizes add up to `size`.
template <class Real>
HWY_INLINE RealBall<Real> rounded(Real middle, Real radius, Real size) {
    const Real error = fused(size, like(size, balls<Real>.rounding), like(size, balls<Real>.least));
    return {.middle = middle, .radius = radius + error};
}

/// The largest size of its numbers, or more.
template <class Real>
HWY_INLINE Real size_of(const RealBall<Real>& a) {
    return magnitude(a.middle) + a.radius;
}
/// c - a b.
template <class Real>
HWY_INLINE RealBall<Real> less_product(const RealBall<Real>& a, const RealBall<Real>& b,
                                       const RealBall<Real>& c) {
    const Real size = magnitude(a.middle);
    return rounded(less_product(a.middle, b.middle, c.middle),
                   fused(size, b.radius, fused(a.radius, size_of(b), c.radius)),
                   fused(size, magnitude(b.middle), magnitude(c.middle)));
}

template <class Real>
HWY_INLINE Vector2<Real> sizes_of(const Vector2<Real>& x) {
    return {.p = magnitude(x.p), .q = magnitude(x.q)};
}
template <class Real>
HWY_INLINE Matrix2<Real> sizes_of(const Matrix2<Real>& m) {
    return {
        .pp = magnitude(m.pp), .pq = magnitude(m.pq), .qp = magnitude(m.qp), .qq = magnitude(m.qq)};
}
template <class Real>
HWY_INLINE Real larger(const Vector2<Real>& x) {
    return maximum(x.p, x.q);
}
/// The larger size of its numbers.
template <class Real>
HWY_INLINE Real size_of(const Vector2<Real>& x) {
    return larger(sizes_of(x));
}
template <class Real>
HWY_INLINE Vector2<Real> row_sizes_of(const Matrix2<Real>& m) {
    return {.p = magnitude(m.pp) + magnitude(m.pq), .q = magnitude(m.qp) + magnitude(m.qq)};
}
/// The norm that belongs to the larger size.
template <class Real>
HWY_INLINE Real norm_of(const Matrix2<Real>& m) {
    return larger(row_sizes_of(m));
}

/// m x, rounded.
template <class Real>
HWY_INLINE Vector2<Real> operator*(const Matrix2<Real>& m, const Vector2<Real>& x) {
    return {.p = fused(m.pq, x.q, m.pp * x.p), .q = fused(m.qp, x.p, m.qq * x.q)};
}
/// A ball's radius with the error of a product of its middle.
template <class Real>
HWY_INLINE Real with_error(const RealBall<Real>& a) {
    return fused(magnitude(a.middle), like(a.middle, balls<Real>.rounding), a.radius);
}
template <class Real>
HWY_INLINE Vector2<RealBall<Real>> operator*(const Matrix2<Real>& m,
                                             const Vector2<RealBall<Real>>& x) {
    const Real p = with_error(x.p);
    const Real q = with_error(x.q);
    const Real least = like(p, balls<Real>.least);
    const auto row = [&](Real by_p, Real by_q) HWY_ATTR {
        return RealBall<Real>{
            .middle = fused(by_p, x.p.middle, by_q * x.q.middle),
            .radius = fused(magnitude(by_p), p, fused(magnitude(by_q), q, least))};
    };
    return {.p = row(m.pp, m.pq), .q = row(m.qp, m.qq)};
}
/// For each row of I - y m, a bound of the sum of its sizes; `rounding` is for the terms of I.
template <class Real>
HWY_INLINE Vector2<Real> rest_of_product(const Matrix2<Real>& y, const Matrix2<RealBall<Real>>& m) {
    const Real one = like(y.pp, 1.0);
    const Real p = with_error(m.pp) + with_error(m.pq);
    const Real q = with_error(m.qp) + with_error(m.qq);
    const Real rounding = like(y.pp, balls<Real>.rounding);
    const auto entry =
        [](Real by_p, Real by_q, const RealBall<Real>& of_p, const RealBall<Real>& of_q)
            HWY_ATTR { return fused(by_p, of_p.middle, by_q * of_q.middle); };
    const auto errors = [&](Real by_p, Real by_q) HWY_ATTR {
        return fused(magnitude(by_p), p, fused(magnitude(by_q), q, rounding));
    };
    return {.p = magnitude(entry(y.pp, y.pq, m.pp, m.qp) - one) +
                 magnitude(entry(y.pp, y.pq, m.pq, m.qq)) + errors(y.pp, y.pq),
            .q = magnitude(entry(y.qp, y.qq, m.pp, m.qp)) +
                 magnitude(entry(y.qp, y.qq, m.pq, m.qq) - one) + errors(y.qp, y.qq)};
}

// Divisor2, Zeros2: with D the determinant, T the sum of the sizes of the two products in it, and
// |D| > `safe` T, D is off by 2 u T, 1 / D so by less than 2^-9 of it, and `safe_growth` times its
// size is a bound. The solution of m x + g = 0 for the middles of g is a quotient by D of sums of
// two products, off by (4 + 2 T / |D|) u of their sizes at most, which `rounding` T / |D| is more
// than; `least_place` is more than what is lost of numbers near d. The radii of g move it by as
// much as the sizes of the matrix make of them.

/// A matrix, to divide by.
template <class Real>
struct Divisor2 {
    Matrix2<Real> m;
    Real determinant;
    Real size;     ///< T
    Real inverse;  ///< 1 / determinant

    /// Where the bounds below hold.
    [[nodiscard]] HWY_INLINE auto is_safe() const {
        constexpr BallFormat format = balls<Real>;
        const Real least =
            maximum(like(size, format.least_determinant), like(size, format.safe) * size);
        return both(magnitude(determinant) > least, size < like(size, format.most_determinant));
    }
    /// A bound of 1 / |determinant|.
    [[nodiscard]] HWY_INLINE Real most() const {
        return magnitude(inverse) * like(size, balls<Real>.safe_growth);
    }
    /// A bound of the error of 1 / determinant and of a few products, relative to these.
    [[nodiscard]] HWY_INLINE Real lost() const {
        return like(size, balls<Real>.rounding) * size * most();
    }
};
template <class Real>
HWY_INLINE Divisor2<Real> divisor_of(const Matrix2<Real>& m) {
    const Real first = m.pp * m.qq;
    const Real second = m.pq * m.qp;
    const Real determinant = first - second;
    return {.m = m,
            .determinant = determinant,
            .size = magnitude(first) + magnitude(second),
            .inverse = like(determinant, 1.0) / determinant};
}

/// The determinant times the solution of m x + g = 0, rounded.
template <class Real>
HWY_INLINE Vector2<Real> zero_by_determinant(const Matrix2<Real>& m, const Vector2<Real>& g) {
    return {.p = less_product(m.qq, g.p, m.pq * g.q), .q = less_product(m.pp, g.q, m.qp * g.p)};
}
/// The inverse of a matrix, with 1 / its determinant given; rounded.
template <class Real>
HWY_INLINE Matrix2<Real> inverse_of(const Matrix2<Real>& m, Real per_determinant) {
    return {.pp = m.qq * per_determinant,
            .pq = negative(m.pq) * per_determinant,
            .qp = negative(m.qp) * per_determinant,
            .qq = m.pp * per_determinant};
}

/// The solutions of m x + g = 0 for all g of two balls.
template <class Real>
struct Zeros2 {
    using Mask = decltype(std::declval<Real>() < std::declval<Real>());

    Vector2<RealBall<Real>> x;
    Real lost;   ///< the part of the larger radius that is by rounding
    Mask known;  ///< else they may be anywhere
};
template <class Real>
HWY_INLINE Zeros2<Real> zeros_of(const Divisor2<Real>& by, const Vector2<RealBall<Real>>& g) {
    const Matrix2<Real>& m = by.m;
    const Matrix2<Real> terms{.pp = m.qq * g.p.middle,
                              .pq = m.pq * g.q.middle,
                              .qp = m.qp * g.p.middle,
                              .qq = m.pp * g.q.middle};
    const Vector2<Real> rounding = row_sizes_of(terms);
    const Vector2<Real> radius =
        sizes_of(Matrix2<Real>{.pp = m.qq, .pq = m.pq, .qp = m.qp, .qq = m.pp}) *
        Vector2<Real>{.p = g.p.radius, .q = g.q.radius};
    const Real lost = by.lost();
    const Real most = by.most();
    const Real p = fused(lost, rounding.p, radius.p);
    const Real q = fused(lost, rounding.q, radius.q);
    const Real finite = like(lost, balls<Real>.most);
    const Real least = like(lost, balls<Real>.least_place);
    return {
        .x = {.p = {.middle = (terms.pq - terms.pp) * by.inverse, .radius = fused(p, most, least)},
              .q = {.middle = (terms.qp - terms.qq) * by.inverse, .radius = fused(q, most, least)}},
        .lost = fused(lost * most, larger(rounding), least),
        .known = both(by.is_safe(), both(p < finite, q < finite))};
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
