// The polynomials of a leaf, and those over halves of it.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_PATCH_PIECES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_PATCH_PIECES_INL
#undef ZEROSET_PATCH_PIECES_INL
#else
#define ZEROSET_PATCH_PIECES_INL
#endif

#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/patch/patch_zeros-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// A polynomial in (p, q), a value for each lane.
struct Polynomial {
    Vector terms[patch_terms];
};

/// A polynomial's value and slopes.
struct Slopes {
    Vector value, by_p, by_q;
};

HWY_INLINE Slopes slopes_of(const Polynomial& f, Vector p, Vector q) {
    Slopes all{
        .value = f.terms[patch_term(patch_degree, 0)], .by_p = number(0.0), .by_q = number(0.0)};
    for (int i = patch_degree - 1; i >= 0; --i) {
        // The terms with p^i, and their slope by q.
        Vector row = f.terms[patch_term(i, patch_degree - i)];
        Vector by_q = row;
        for (int j = patch_degree - i - 1; j >= 1; --j) {
            row = hn::MulAdd(row, q, f.terms[patch_term(i, j)]);
            by_q = hn::MulAdd(by_q, q, row);
        }
        row = hn::MulAdd(row, q, f.terms[patch_term(i, 0)]);
        all.by_p = i == patch_degree - 1 ? all.value : hn::MulAdd(all.by_p, p, all.value);
        all.value = hn::MulAdd(all.value, p, row);
        all.by_q = i == patch_degree - 1 ? by_q : hn::MulAdd(all.by_q, p, by_q);
    }
    return all;
}

/// A box in (p, q) of a leaf, with its polynomials.
struct Piece {
    SightTerms terms;
    double value_error;
    UvBox box;
    int halvings;
    PatchSight sight;
    Contraction contraction;
};

/// The polynomials over a half of a box, along p or along q.
inline void halve(const Piece& whole, bool along_p, double sign, Piece& half) {
    const hn::CappedTag<double, 4> d4;
    constexpr std::size_t step = hn::MaxLanes(hn::CappedTag<double, 4>());
    const auto shift = hn::Set(d4, sign * half_shift);
    double size = 0.0;
    for (std::size_t k = 0; k < 4; k += step) {
        hn::Vec<decltype(d4)> terms[patch_degree + 1];
        for (int other = 0; other <= patch_degree; ++other) {
            const int degree = patch_degree - other;
            const auto term = [&](int i) {
                return along_p ? patch_term(i, other) : patch_term(other, i);
            };
            for (int i = 0; i <= degree; ++i)
                terms[i] = hn::LoadU(d4, whole.terms[term(i)].data() + k);
            for (int i = 0; i < degree; ++i) {
                for (int j = degree - 1; j >= i; --j)
                    terms[j] = hn::MulAdd(terms[j + 1], shift, terms[j]);
            }
            double scale = 1.0;
            for (int i = 0; i <= degree; ++i) {
                hn::StoreU(hn::Mul(terms[i], hn::Set(d4, scale)), d4,
                           half.terms[term(i)].data() + k);
                scale *= 0.5;
            }
        }
    }
    for (const auto& term : whole.terms)
        size += std::abs(term[0]) + std::abs(term[1]) + std::abs(term[2]);
    half.value_error = whole.value_error + 0x1p-48 * size;
    half.halvings = whole.halvings + 1;
    half.box = whole.box;
    (along_p ? half.box.u : half.box.v) +=
        sign * half_shift * (along_p ? whole.box.u_radius : whole.box.v_radius);
    (along_p ? half.box.u_radius : half.box.v_radius) *= 0.5;
}

/// Sets the linear form of a piece.
inline void see(Piece& piece) {
    const hn::CappedTag<double, 4> d4;
    constexpr std::size_t step = hn::MaxLanes(hn::CappedTag<double, 4>());
    HWY_ALIGN double c[4];
    HWY_ALIGN double e[4];
    HWY_ALIGN double by_p[4];
    HWY_ALIGN double by_q[4];
    HWY_ALIGN double size[4];
    for (std::size_t k = 0; k < 4; k += step) {
        const auto load = [&](std::size_t i)
                              HWY_ATTR { return hn::LoadU(d4, piece.terms[i].data() + k); };
        const auto zero = hn::Zero(d4);
        auto middle = load(0);
        auto whole = hn::Add(hn::Abs(middle), hn::Add(hn::Abs(load(1)), hn::Abs(load(2))));
        auto spread = zero;
        auto p = zero;
        auto q = zero;
        for (std::size_t i = patch_term(2, 0); i < patch_terms; ++i) {
            const auto term = load(i);
            const auto most = hn::Abs(term);
            const PatchPower power = patch_powers[i];
            whole = hn::Add(whole, most);
            p = hn::MulAdd(most, hn::Set(d4, power.p), p);
            q = hn::MulAdd(most, hn::Set(d4, power.q), q);
            // Powers that are even run from 0 to 1.
            const bool is_even = power.p % 2 == 0 && power.q % 2 == 0;
            const auto half = hn::Set(d4, 0.5);
            if (is_even) middle = hn::MulAdd(term, half, middle);
            spread = hn::MulAdd(most, is_even ? half : hn::Set(d4, 1.0), spread);
        }
        hn::Store(middle, d4, c + k);
        hn::Store(spread, d4, e + k);
        hn::Store(p, d4, by_p + k);
        hn::Store(q, d4, by_q + k);
        hn::Store(whole, d4, size + k);
    }
    const auto vector = [](const double* from) { return glm::dvec3(from[0], from[1], from[2]); };
    PatchSight& sight = piece.sight;
    const double lost = rounding * std::max({size[0], size[1], size[2]});
    sight.c = vector(c);
    sight.kp = sight.dp = vector(piece.terms[patch_term(1, 0)].data());
    sight.kq = sight.dq = vector(piece.terms[patch_term(0, 1)].data());
    sight.value_error = piece.value_error + lost;
    sight.e = vector(e) + sight.value_error;
    sight.dp_radius = vector(by_p) + rounding * glm::abs(sight.dp);
    sight.dq_radius = vector(by_q) + rounding * glm::abs(sight.dq);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
