// g and its zeros for one ray or a vector of them: the equations of patch_sight.hpp over a carrier.
// In upward rounding. Included once for each instruction set, after Highway.

#if defined(ZEROSET_SIGHT_ALGEBRA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_SIGHT_ALGEBRA_INL
#undef ZEROSET_SIGHT_ALGEBRA_INL
#else
#define ZEROSET_SIGHT_ALGEBRA_INL
#endif

#include "engine/trace/patch/balls-inl.hpp"
#include "engine/trace/patch/patch_sight.hpp"

#include <hwy/highway.h>

#include <cmath>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// (a, b, s), or how much these vary, as numbers of a carrier.
template <class Real>
struct InAxes {
    Real x, y, z;
};
template <class Real>
HWY_INLINE InAxes<Real> in_axes(const glm::dvec3& of) {
    const Real kind{};
    return {.x = like(kind, of.x), .y = like(kind, of.y), .z = like(kind, of.z)};
}

/// The ray of (u, v).
template <class Real>
struct SightLine {
    Real u, v;

    /// (a - u s, b - v s), as in g's derivatives.
    [[nodiscard]] HWY_INLINE Vector2<Real> across(const InAxes<Real>& of) const {
        return {.p = less_product(u, of.z, of.x), .q = less_product(v, of.z, of.y)};
    }
    /// g at a point.
    [[nodiscard]] HWY_INLINE Vector2<Real> g(const InAxes<Real>& at, Real distance) const {
        return across({.x = less_product(u, distance, at.x),
                       .y = less_product(v, distance, at.y),
                       .z = at.z});
    }
    /// Bounds of the sizes of across() by those of (a, b, s).
    [[nodiscard]] HWY_INLINE Vector2<Real> most(const InAxes<Real>& sizes) const {
        return {.p = fused(magnitude(u), sizes.z, sizes.x),
                .q = fused(magnitude(v), sizes.z, sizes.y)};
    }
    /// g at a point that is known up to an error in each coordinate.
    [[nodiscard]] HWY_INLINE Vector2<RealBall<Real>> g(const InAxes<Real>& at, Real distance,
                                                       Real error) const {
        const Vector2<Real> middle = g(at, distance);
        const Vector2<Real> errors = most({.x = error, .y = error, .z = error});
        const Vector2<Real> sizes =
            most({.x = magnitude(at.x), .y = magnitude(at.y), .z = distance + magnitude(at.z)});
        return {.p = rounded(middle.p, errors.p, sizes.p),
                .q = rounded(middle.q, errors.q, sizes.q)};
    }
};

/// The linear form of g over a box, with slopes that are exact.
template <class Real>
struct LinearG {
    Matrix2<Real> slopes;
    Vector2<RealBall<Real>> middle;

    /// Whether g has no zero with |p|, |q| <= share.
    [[nodiscard]] HWY_INLINE auto misses(double share) const {
        const Vector2<Real> rows = row_sizes_of(slopes);
        const Real wider = like(rows.p, share * (1.0 + balls<Real>.rounding));
        return either(magnitude(middle.p.middle) > fused(rows.p, wider, middle.p.radius),
                      magnitude(middle.q.middle) > fused(rows.q, wider, middle.q.radius));
    }
};
/// A form c + kp p + kq q, up to e; its e holds what rounding makes of g, too.
template <class Real>
HWY_INLINE LinearG<Real> linear_g(const SightLine<Real>& ray, const InAxes<Real>& c,
                                  const InAxes<Real>& kp, const InAxes<Real>& kq,
                                  const InAxes<Real>& e, Real distance) {
    const Vector2<Real> by_p = ray.across(kp);
    const Vector2<Real> by_q = ray.across(kq);
    const Vector2<Real> middle = ray.g(c, distance);
    const Vector2<Real> radius = ray.most(e);
    return {.slopes = {.pp = by_p.p, .pq = by_q.p, .qp = by_p.q, .qq = by_q.q},
            .middle = {.p = {.middle = middle.p, .radius = radius.p},
                       .q = {.middle = middle.q, .radius = radius.q}}};
}

/// A step of Krawczyk's test of a box from a place of it.
template <class Real>
struct KrawczykStep {
    using Mask = decltype(std::declval<Real>() < std::declval<Real>());

    Mask known;            ///< else the rest says nothing
    Vector2<Real> by;      ///< -Y g
    Real lost;             ///< a bound of its error
    Real reach;            ///< any zero of the box is within this of the place
    Real radius;           ///< and within this of where the step leads
    RealBall<Real> depth;  ///< where on the ray it is
};
template <class Real>
HWY_INLINE KrawczykStep<Real> krawczyk_step(const Contraction& box, const PatchSight& sight,
                                            const Vector2<RealBall<Real>>& g,
                                            const Vector2<Real>& from, Real s) {
    const auto number = [&](double of) HWY_ATTR { return like(s, of); };
    const Matrix2<double>& y = box.inverse;
    const Vector2<RealBall<Real>> step =
        Matrix2<Real>{
            .pp = number(y.pp), .pq = number(y.pq), .qp = number(y.qp), .qq = number(y.qq)} *
        g;
    const Vector2<Real> by{.p = negative(step.p.middle), .q = negative(step.q.middle)};
    const Real lost = maximum(step.p.radius, step.q.radius);
    // 1 / (1 - norm), with 1 - norm rounded downward.
    const double per_rest = 1.0 / -(box.norm - 1.0);
    const Real reach = (size_of(by) + lost) * number(per_rest);
    const Real far = minimum(reach, number(1.0) + size_of(from));
    const Real radius = fused(number(box.norm), far, lost) + number(0x1p-50);
    // The zero's depth: by the slopes in the middle, and by how far they vary.
    const Vector2<Real> sizes = sizes_of(by);
    const Real middle = fused(number(sight.dp.z), by.p, fused(number(sight.dq.z), by.q, s));
    const Real along =
        fused(number(sight.dp_radius.z), sizes.p, number(sight.dq_radius.z) * sizes.q);
    const double slope =
        std::abs(sight.dp.z) + sight.dp_radius.z + std::abs(sight.dq.z) + sight.dq_radius.z;
    const Real error = fused(number(slope), radius, along + number(sight.value_error));
    // A sum, as it is NaN where one of its terms is.
    const Real all = (size_of(g.p) + size_of(g.q)) + (size_of(step.p) + size_of(step.q));
    return {.known = all < number(balls<Real>.most),
            .by = by,
            .lost = lost,
            .reach = reach,
            .radius = radius,
            .depth = rounded(middle, error, fused(number(slope), larger(sizes), magnitude(s)))};
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
