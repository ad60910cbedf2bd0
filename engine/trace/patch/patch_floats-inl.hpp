// The polynomials of a piece in float, for vectors of rays.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_FLOATS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_FLOATS_INL
#undef ZEROSET_PATCH_FLOATS_INL
#else
#define ZEROSET_PATCH_FLOATS_INL
#endif

#include "engine/trace/patch/patch_pieces-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A polynomial's value and slopes.
struct FloatSlopes {
    V<float> value, by_p, by_q;
};

/// The terms of a piece in float: of (a, b, s). Those below degree 2 are 0 in `terms`.
struct FloatTerms {
    float terms[patch_terms][4];
    float by_p[4], by_q[4];  ///< p, q

    explicit FloatTerms(const Piece& piece) {
        const D4 d4;
        const hn::Rebind<float, D4> f4;
        for (std::size_t k = 0; k < 4; k += step4) {
            const auto put = [&](std::size_t i, float* to) HWY_ATTR {
                hn::StoreU(hn::DemoteTo(f4, hn::Load(d4, piece.terms[i].data() + k)), f4, to + k);
            };
            constexpr std::size_t first = patch_term(2, 0);
            for (std::size_t i = 0; i < first; ++i)
                hn::StoreU(hn::Zero(f4), f4, terms[i] + k);
            put(patch_term(1, 0), by_p);
            put(patch_term(0, 1), by_q);
            for (std::size_t i = first; i < terms_of(piece.degree); ++i)
                put(i, terms[i]);
        }
    }
};

/// The terms of a coordinate from a degree on, 2 or 3, and the slopes of all terms.
template <int degree, int first = 2>
HWY_INLINE FloatSlopes high_terms_of(const FloatTerms& f, int k, V<float> p, V<float> q) {
    const auto term = [&](int i, int j)
                          HWY_ATTR { return hn::Set(d<float>, f.terms[patch_term(i, j)][k]); };
    // The slopes of the terms below the first degree.
    const auto low = [&](const float* linear, V<float> square, V<float> at,
                         V<float> other) HWY_ATTR {
        const V<float> by = hn::Set(d<float>, linear[k]);
        if constexpr (first == 2) return by;
        return hn::MulAdd(hn::Add(square, square), at, hn::MulAdd(term(1, 1), other, by));
    };
    const V<float> low_p = low(f.by_p, term(2, 0), p, q);
    const V<float> low_q = low(f.by_q, term(0, 2), q, p);
    if constexpr (degree < first)
        return {.value = hn::Zero(d<float>), .by_p = low_p, .by_q = low_q};
    FloatSlopes all{
        .value = term(degree, 0), .by_p = hn::Zero(d<float>), .by_q = hn::Zero(d<float>)};
    for (int i = degree - 1; i >= 0; --i) {
        // The terms with p^i, and their slope by q.
        V<float> row = term(i, degree - i);
        V<float> by_q = row;
        const int lowest = std::max(0, first - i);
        for (int j = degree - i - 1; j >= 1; --j) {
            row = j >= lowest ? hn::MulAdd(row, q, term(i, j)) : hn::Mul(row, q);
            by_q = hn::MulAdd(by_q, q, row);
        }
        row = lowest > 0 ? hn::Mul(row, q) : hn::MulAdd(row, q, term(i, 0));
        all.by_p = i == degree - 1 ? all.value : hn::MulAdd(all.by_p, p, all.value);
        all.value = hn::MulAdd(all.value, p, row);
        all.by_q = i == degree - 1 ? by_q : hn::MulAdd(all.by_q, p, by_q);
    }
    all.by_p = hn::Add(all.by_p, low_p);
    all.by_q = hn::Add(all.by_q, low_q);
    return all;
}

/// A coordinate, but for its constant.
template <int degree>
HWY_INLINE FloatSlopes slopes_of(const FloatTerms& f, int k, V<float> p, V<float> q) {
    FloatSlopes all = high_terms_of<degree>(f, k, p, q);
    const V<float> by_q = hn::Mul(hn::Set(d<float>, f.by_q[k]), q);
    all.value = hn::Add(all.value, hn::MulAdd(hn::Set(d<float>, f.by_p[k]), p, by_q));
    return all;
}

/// (a, b, s) at a place, but for some terms, and its slopes.
struct FloatPoint {
    InAxes<V<float>> value, by_p, by_q;
};
/// The point of a polynomial for each coordinate, of(0) to of(2).
template <class Polynomial>
HWY_INLINE FloatPoint point_of(Polynomial of) {
    const FloatSlopes a = of(0);
    const FloatSlopes b = of(1);
    const FloatSlopes s = of(2);
    return {.value = {.x = a.value, .y = b.value, .z = s.value},
            .by_p = {.x = a.by_p, .y = b.by_p, .z = s.by_p},
            .by_q = {.x = a.by_q, .y = b.by_q, .z = s.by_q}};
}
/// The derivatives of g there.
HWY_INLINE Matrix2<V<float>> slopes_of_g(const SightLine<V<float>>& ray, const FloatPoint& at) {
    const Vector2<V<float>> by_p = ray.across(at.by_p);
    const Vector2<V<float>> by_q = ray.across(at.by_q);
    return {.pp = by_p.p, .pq = by_q.p, .qp = by_p.q, .qq = by_q.q};
}

/// A matrix with 1 over its determinant, for steps whose errors are bounded elsewhere.
struct Slopes2 {
    Matrix2<V<float>> m;
    V<float> inverse;

    explicit HWY_INLINE Slopes2(const Matrix2<V<float>>& of) : m(of) {
        const V<float> determinant = hn::NegMulAdd(m.pq, m.qp, hn::Mul(m.pp, m.qq));
        inverse = hn::Div(number<float>(1.0), determinant);
    }
    [[nodiscard]] HWY_INLINE Matrix2<V<float>> inverse_matrix() const {
        return inverse_of(m, inverse);
    }
    /// Newton's step where the function with these derivatives is g.
    [[nodiscard]] HWY_INLINE Vector2<V<float>> step(const Vector2<V<float>>& g) const {
        const Vector2<V<float>> by = zero_by_determinant(m, g);
        return {.p = hn::Mul(by.p, inverse), .q = hn::Mul(by.q, inverse)};
    }
};

HWY_INLINE V<float> clamped(V<float> at, double limit) {
    const V<float> most = number<float>(limit);
    return hn::Min(hn::Max(at, hn::Neg(most)), most);
}
/// A step from `at` within |p|, |q| <= limit; none where it is not known.
HWY_INLINE Vector2<V<float>> moved(const Vector2<V<float>>& at, const Vector2<V<float>>& by,
                                   double limit) {
    const auto along = [&](V<float> from, V<float> step) HWY_ATTR {
        return hn::IfThenElse(hn::IsNaN(step), from, clamped(hn::Add(from, step), limit));
    };
    return {.p = along(at.p, by.p), .q = along(at.q, by.q)};
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
