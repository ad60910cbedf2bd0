// Where rays are inside sections and balls.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_REGION_CLIP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_REGION_CLIP_INL
#undef ZEROSET_REGION_CLIP_INL
#else
#define ZEROSET_REGION_CLIP_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/scene/region.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Rays in vectors: the points origin + t direction. D: doubles.
template <class D>
struct RayVectors {
    hn::Vec<D> origin[3], direction[3];
};

/// Where some rays enter and leave something convex, each between two bounds of t.
template <class D>
class InsideSpans {
public:
    using V = hn::Vec<D>;

    /// `from`: t before which nothing is inside; it is known to `error`.
    InsideSpans(double from, double error)
        : enter_lo(hn::Set(d, from - error)), enter_hi(hn::Set(d, from + error)) {}

    V enter_lo, enter_hi;
    V exit_lo = hn::Inf(d);
    V exit_hi = exit_lo;

    /// Enters at `at`, up to `error`.
    HWY_INLINE void enter(V at, V error) {
        enter_lo = hn::Max(enter_lo, hn::Sub(at, error));
        enter_hi = hn::Max(enter_hi, hn::Add(at, error));
    }
    HWY_INLINE void leave(V at, V error) {
        exit_lo = hn::Min(exit_lo, hn::Sub(at, error));
        exit_hi = hn::Min(exit_hi, hn::Add(at, error));
    }
    /// Keeps what the section keeps; `error`: of distances from it.
    void keep(const Section& section, double error, const RayVectors<D>& rays);
    /// `error`: of distances from the ball's surface.
    void keep(const Ball& ball, double error, const RayVectors<D>& rays);

    /// Finite: a ray that moves by less stays where it is.
    static HWY_INLINE V inverse_of(V step) {
        const V least = hn::Max(hn::Abs(step), hn::Set(d, 1e-270));
        return hn::Div(hn::Set(d, 1.0), hn::CopySign(least, step));
    }

private:
    static constexpr D d{};

    static V dot(const V* a, const V* b) {
        return hn::MulAdd(a[0], b[0], hn::MulAdd(a[1], b[1], hn::Mul(a[2], b[2])));
    }
    static V dot(const glm::dvec3& a, const V* b) {
        const V constants[3] = {hn::Set(d, a.x), hn::Set(d, a.y), hn::Set(d, a.z)};
        return dot(constants, b);
    }
};

template <class D>
void InsideSpans<D>::keep(const Section& section, double error, const RayVectors<D>& rays) {
    const V height = hn::Sub(dot(section.normal, rays.origin), hn::Set(d, section.offset));
    const V inverse = inverse_of(dot(section.normal, rays.direction));
    const V at = hn::Neg(hn::Mul(height, inverse));
    const V at_error = hn::Mul(hn::Set(d, error), hn::Abs(inverse));
    const V far = hn::Inf(d);
    const auto rises = hn::Gt(inverse, hn::Zero(d));
    enter(hn::IfThenElse(rises, hn::Neg(far), at), at_error);
    leave(hn::IfThenElse(rises, at, far), at_error);
}

/// By the distance of each ray from the centre: with t of the nearest point and the gap there, the
/// ray is inside the ball for sqrt(radius^2 - gap^2) on either side. Errors of places are those of
/// the radius.
template <class D>
void InsideSpans<D>::keep(const Ball& ball, double error, const RayVectors<D>& rays) {
    const V margin = hn::Set(d, error);
    V from[3], middle[3];
    for (int k = 0; k < 3; ++k)
        from[k] = hn::Sub(rays.origin[k], hn::Set(d, ball.centre[k]));
    const V inverse = hn::Div(hn::Set(d, 1.0), dot(rays.direction, rays.direction));
    const V nearest = hn::Neg(hn::Mul(dot(from, rays.direction), inverse));
    for (int k = 0; k < 3; ++k)
        middle[k] = hn::MulAdd(nearest, rays.direction[k], from[k]);
    const V gap = hn::Sqrt(dot(middle, middle));
    const V far = hn::Inf(d);
    const auto half = [&](V radius) {
        const V product = hn::Mul(hn::Sub(radius, gap), hn::Add(radius, gap));
        return hn::Sqrt(hn::Mul(hn::Max(product, hn::Zero(d)), inverse));
    };
    const V outer = hn::Set(d, ball.radius + error);
    const V inner = hn::Set(d, ball.radius - error);
    const auto missed = hn::Gt(gap, outer);
    const auto sure = hn::Gt(inner, gap);
    const V at_most = hn::IfThenElse(missed, hn::Neg(far), hn::Add(half(outer), margin));
    const V at_least = hn::IfThenElse(sure, hn::Sub(half(inner), margin), hn::Neg(far));
    enter_lo = hn::Max(enter_lo, hn::Sub(nearest, at_most));
    enter_hi = hn::Max(enter_hi, hn::Sub(nearest, at_least));
    exit_lo = hn::Min(exit_lo, hn::Add(nearest, at_least));
    exit_hi = hn::Min(exit_hi, hn::Add(nearest, at_most));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
