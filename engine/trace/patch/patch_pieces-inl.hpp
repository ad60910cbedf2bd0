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

using D4 = hn::CappedTag<double, 4>;
using V4 = hn::Vec<D4>;
/// The vectors that a term of the three coordinates and a fourth number are in.
constexpr std::size_t step4 = hn::MaxLanes(D4());

/// How many terms polynomials of a degree have.
constexpr std::size_t terms_of(int degree) { return patch_term(0, degree) + 1; }

/// Sums of the sizes of the terms of each degree, in a coordinate each.
using DegreeSizes = std::array<std::array<double, 4>, std::size_t{patch_degree} + 1>;

/// A box in (p, q) of a leaf, with its polynomials up to a degree; the other terms are not set.
struct Piece {
    HWY_ALIGN SightTerms terms;
    HWY_ALIGN DegreeSizes sizes;
    int degree;
    double value_error;
    int first_degree;    ///< of what is tried first
    double first_error;  ///< bounds the terms beyond that
    UvBox box;
    int halvings;
    PatchSight sight;
    Contraction contraction;
};

/// Calls `call` with the degree as a constant, from 2 on.
template <class Call>
HWY_INLINE auto with_degree(int degree, Call call) {
    if (degree <= 2) return call(std::integral_constant<int, 2>());
    if (degree == 3) return call(std::integral_constant<int, 3>());
    if (degree == 4) return call(std::integral_constant<int, 4>());
    if (degree == 5) return call(std::integral_constant<int, 5>());
    if (degree == 6) return call(std::integral_constant<int, 6>());
    return call(std::integral_constant<int, patch_degree>());
}

/// Sets the sizes of terms up to a degree.
inline void measure(Piece& piece) {
    const D4 d4;
    for (std::size_t k = 0; k < 4; k += step4) {
        for (int degree = 0; degree <= piece.degree; ++degree) {
            V4 size = hn::Zero(d4);
            for (std::size_t i = patch_term(degree, 0); i < terms_of(degree); ++i)
                size = hn::Add(size, hn::Abs(hn::Load(d4, piece.terms[i].data() + k)));
            hn::Store(size, d4, piece.sizes[static_cast<std::size_t>(degree)].data() + k);
        }
    }
}

/// The shares of the tolerance up to which terms of high degree are left out: from what is proved,
/// and from what is tried first.
constexpr double left_out = 0x1p-10;
constexpr double left_out_first = 0x1p-4;

/// Lowers a degree while the sizes of the terms left out add up to no more than `most`; returns
/// that sum.
inline double lowered(const DegreeSizes& sizes, int& degree, double most) {
    std::array<double, 3> sum{};
    double left = 0.0;
    for (; degree > 2; --degree) {
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += sizes[static_cast<std::size_t>(degree)][k];
        const double all = std::max({sum[0], sum[1], sum[2]});
        if (!(all <= most)) break;
        left = all;
    }
    return left;
}

/// Sets the degree of a piece of which only the sizes of its model are known, as lower_degree does.
inline void set_degree(Piece& piece, const ModelSizes& sizes, double tolerance) {
    double sum = 0.0;
    double left = 0.0;
    for (piece.degree = patch_degree; piece.degree > 2; --piece.degree) {
        sum += double{sizes[static_cast<std::size_t>(piece.degree)]};
        // Axes have length 1 but for rounding.
        if (!(sum * (1.0 + 0x1p-40) <= left_out * tolerance)) break;
        left = sum;
    }
    piece.value_error += left * (1.0 + 0x1p-40);
}

/// Leaves out terms of high degree from the first steps alone; their sizes go to first_error.
inline void lower_first_degree(Piece& piece, double tolerance) {
    piece.first_degree = piece.degree;
    piece.first_error = lowered(piece.sizes, piece.first_degree, left_out_first * tolerance);
}

/// Leaves out terms of high degree; their sizes go to value_error.
inline void lower_degree(Piece& piece, double tolerance) {
    piece.value_error += lowered(piece.sizes, piece.degree, left_out * tolerance);
    lower_first_degree(piece, tolerance);
}

/// Sets the polynomials to those of a model in the axes of a view, up to the piece's degree.
inline void turn(const PatchModel& model, const SightAxes& axes, Piece& piece) {
    const D4 d4;
    for (std::size_t k = 0; k < 4; k += step4) {
        V4 by[3];
        for (int axis = 0; axis < 3; ++axis) {
            HWY_ALIGN const double turned[4] = {axes.right[axis], axes.up[axis], axes.forward[axis],
                                                0.0};
            by[axis] = hn::Load(d4, turned + k);
        }
        for (std::size_t i = 0; i < terms_of(piece.degree); ++i) {
            double x = model.terms[0][i];
            double y = model.terms[1][i];
            double z = model.terms[2][i];
            if (i == 0) {
                x -= axes.base.x;
                y -= axes.base.y;
                z -= axes.base.z;
            }
            V4 term = hn::Mul(by[0], hn::Set(d4, x));
            term = hn::MulAdd(by[1], hn::Set(d4, y), term);
            hn::Store(hn::MulAdd(by[2], hn::Set(d4, z), term), d4, piece.terms[i].data() + k);
        }
    }
}

template <int degree>
HWY_INLINE void halve_terms(const SightTerms& whole, bool along_p, double sign, SightTerms& half) {
    const D4 d4;
    const V4 shift = hn::Set(d4, sign * half_shift);
    for (std::size_t k = 0; k < 4; k += step4) {
        for (int other = 0; other <= degree; ++other) {
            V4 terms[std::size_t{degree} + 1];
            const int highest = degree - other;
            const auto term = [&](int i) {
                return along_p ? patch_term(i, other) : patch_term(other, i);
            };
            for (int i = 0; i <= highest; ++i)
                terms[i] = hn::Load(d4, whole[term(i)].data() + k);
            // Shift the polynomial to the middle of the half, by Horner's scheme.
            for (int i = 0; i < highest; ++i) {
                for (int j = highest - 1; j >= i; --j)
                    terms[j] = hn::MulAdd(terms[j + 1], shift, terms[j]);
            }
            // Scale it to the half's radius.
            double scale = 1.0;
            for (int i = 0; i <= highest; ++i) {
                hn::Store(hn::Mul(terms[i], hn::Set(d4, scale)), d4, half[term(i)].data() + k);
                scale *= 0.5;
            }
        }
    }
}

/// The polynomials over a half of a box, along p or along q.
inline void halve(const Piece& whole, bool along_p, double sign, Piece& half) {
    half.degree = with_degree(whole.degree, [&](auto degree) HWY_ATTR {
        halve_terms<degree()>(whole.terms, along_p, sign, half.terms);
        return static_cast<int>(degree);
    });
    measure(half);
    double size = 0.0;
    for (int n = 0; n <= whole.degree; ++n) {
        const auto& sizes = whole.sizes[static_cast<std::size_t>(n)];
        size += sizes[0] + sizes[1] + sizes[2];
    }
    half.value_error = whole.value_error + 0x1p-48 * size;
    half.halvings = whole.halvings + 1;
    half.box = whole.box;
    (along_p ? half.box.u : half.box.v) +=
        sign * half_shift * (along_p ? whole.box.u_radius : whole.box.v_radius);
    (along_p ? half.box.u_radius : half.box.v_radius) *= 0.5;
}

/// Whether nearly all of the error of g's linear form in float would be that of a half, too: rays
/// so near to being tangent would stay open in each half.
inline bool is_all_error(const Piece& piece, const SightAxes& axes, const SightRays& rays) {
    const PatchSight& sight = piece.sight;
    const auto is_error = [&](int axis, double along) {
        const double in_float =
            LinearForm::float_rounding *
            (std::abs(sight.c[axis]) + along * (std::abs(sight.c.z) + axes.distance));
        const double of_values = sight.value_error * (1.0 + along);
        return sight.e[axis] + along * sight.e.z <= 1.25 * of_values + 0.5 * in_float;
    };
    return is_error(0, std::abs(rays.middle.u) + rays.u_radius) &&
           is_error(1, std::abs(rays.middle.v) + rays.v_radius);
}

/// Whether halves along p bend less than those along q, for rays near some ray. That is how much
/// the derivatives of g vary relative to their inverse Y in the middle: halves along p have a half
/// of dS/dp, so that a row of Y is doubled, and a quarter or a half of the second derivatives. (At
/// the tip of a cone, where dS/dp is 0, its halves along p bend as it does itself.) A tip in the
/// very middle has no Y: there the radii of the derivatives tell.
inline bool halves_along_p(const Piece& piece, const SightRay& ray) {
    const Matrix2<double>& y = piece.contraction.inverse;
    const SightLine<double> line{.u = ray.u, .v = ray.v};
    const auto bend = [&](int by_p, int by_q, double times) {
        const auto& term = piece.terms[patch_term(by_p, by_q)];
        const auto [p, q] = sizes_of(y * line.across({.x = term[0], .y = term[1], .z = term[2]}));
        return Vector2<double>{.p = times * p, .q = times * q};
    };
    const Vector2<double> pp = bend(2, 0, 2.0);
    const Vector2<double> pq = bend(1, 1, 2.0);
    const Vector2<double> qq = bend(0, 2, 2.0);
    const Vector2<double> along_p{.p = 0.5 * pp.p + pq.p + 2.0 * qq.p,
                                  .q = 0.25 * pp.q + 0.5 * pq.q + qq.q};
    const Vector2<double> along_q{.p = pp.p + 0.5 * pq.p + 0.25 * qq.p,
                                  .q = 2.0 * pp.q + pq.q + 0.5 * qq.q};
    const double by_p = larger(along_p);
    const double by_q = larger(along_q);
    if (std::isfinite(y.pp + y.pq + y.qp + y.qq) && by_p != by_q) return by_p < by_q;
    const PatchSight& sight = piece.sight;
    const auto sum = [](const glm::dvec3& of) { return of.x + of.y; };
    return sum(sight.dp_radius) + 0x1p-20 * sum(glm::abs(sight.dp)) >=
           sum(sight.dq_radius) + 0x1p-20 * sum(glm::abs(sight.dq));
}

/// Sets the linear form of a piece.
template <int degree>
HWY_INLINE void see_terms(Piece& piece) {
    const D4 d4;
    HWY_ALIGN double c[4];
    HWY_ALIGN double e[4];
    HWY_ALIGN double by_p[4];
    HWY_ALIGN double by_q[4];
    HWY_ALIGN double size[4];
    for (std::size_t k = 0; k < 4; k += step4) {
        const auto load = [&](std::size_t i)
                              HWY_ATTR { return hn::Load(d4, piece.terms[i].data() + k); };
        const auto zero = hn::Zero(d4);
        auto middle = load(0);
        auto whole = hn::Add(hn::Abs(middle), hn::Add(hn::Abs(load(1)), hn::Abs(load(2))));
        auto spread = zero;
        auto p = zero;
        auto q = zero;
        for (std::size_t i = patch_term(2, 0); i < terms_of(degree); ++i) {
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

inline void see(Piece& piece) {
    with_degree(piece.degree, [&](auto degree) HWY_ATTR { see_terms<degree()>(piece); });
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
