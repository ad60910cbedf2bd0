// f and its gradient on rays of a tile, for vectors of rays.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_RAY_VALUES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_RAY_VALUES_INL
#undef ZEROSET_RAY_VALUES_INL
#else
#define ZEROSET_RAY_VALUES_INL
#endif

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/numbers-inl.hpp"
#include "engine/kernel/batches.hpp"
#include "engine/real/lanes-inl.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

struct Vectors3 {
    V<double> x, y, z;
};
HWY_INLINE Vectors3 splat(const glm::dvec3& v) {
    return {.x = number(v.x), .y = number(v.y), .z = number(v.z)};
}
HWY_INLINE V<double> dot(const Vectors3& a, const Vectors3& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
/// a + s b
HWY_INLINE Vectors3 along(const Vectors3& a, V<double> s, const Vectors3& b) {
    return {
        .x = hn::MulAdd(s, b.x, a.x), .y = hn::MulAdd(s, b.y, a.y), .z = hn::MulAdd(s, b.z, a.z)};
}

/// Rays: the point at depth s is origin + s direction.
struct LinesOfRays {
    Vectors3 origin, direction;
};

/// The rays of a tile, for vectors of them.
class TileLines {
public:
    explicit TileLines(const TileRays& rays)
        : right_(splat(rays.axes().right)),
          up_(splat(rays.axes().up)),
          base_(splat(rays.base())),
          forward_(splat(rays.axes().forward)),
          distance_(number(rays.distance())),
          pixel_(number(rays.pixel())),
          least_error_(number(2.0 * rays.depth_error())) {}

    [[nodiscard]] HWY_INLINE LinesOfRays at(V<double> u, V<double> v) const {
        const Vectors3 zero{
            .x = hn::Zero(d<double>), .y = hn::Zero(d<double>), .z = hn::Zero(d<double>)};
        const Vectors3 across = along(along(zero, v, up_), u, right_);
        return {.origin = along(base_, distance_, across),
                .direction = {.x = hn::Add(forward_.x, across.x),
                              .y = hn::Add(forward_.y, across.y),
                              .z = hn::Add(forward_.z, across.z)}};
    }
    /// A pixel's width at a depth.
    [[nodiscard]] HWY_INLINE V<double> pixel_at(V<double> s) const {
        return hn::Mul(pixel_, hn::Add(distance_, s));
    }
    /// How well the depth of a root is known.
    [[nodiscard]] HWY_INLINE V<double> error_of_root(V<double> s) const {
        return hn::Max(hn::Mul(number(root_error), pixel_at(s)), least_error_);
    }
    /// How f changes from ray to ray at the same depth, a pixel to the right and downwards.
    [[nodiscard]] HWY_INLINE V<double> by_col(const Vectors3& gradient, V<double> s) const {
        return hn::Mul(pixel_at(s), dot(gradient, right_));
    }
    [[nodiscard]] HWY_INLINE V<double> by_row(const Vectors3& gradient, V<double> s) const {
        return hn::Neg(hn::Mul(pixel_at(s), dot(gradient, up_)));
    }

private:
    Vectors3 right_, up_, base_, forward_;
    V<double> distance_, pixel_, least_error_;
};

/// Some points, and f and its gradient there. Plain data, nothing of it set at first.
struct RayPoints {
    static constexpr std::size_t capacity = 512;
    static constexpr std::size_t at_once = 256;

    alignas(64) double x[3][capacity], f[capacity], gradient[3][capacity];

    HWY_INLINE void ask(std::size_t i, const LinesOfRays& lines, V<double> s) {
        const Vectors3 at = along(lines.origin, s, lines.direction);
        store(at.x, x[0] + i);
        store(at.y, x[1] + i);
        store(at.z, x[2] + i);
    }
    /// Evaluates the first `size`, a multiple of batch_multiple.
    void evaluate(const TraceFrame& frame, std::size_t size) {
        for (std::size_t i = 0; i < size; i += at_once) {
            frame.kernel.in_double.value(
                {.size = std::min(at_once, size - i),
                 .x = {x[0] + i, x[1] + i, x[2] + i},
                 .uniforms = frame.scene.uniforms.points<double>(),
                 .f = f + i,
                 .gradient = {gradient[0] + i, gradient[1] + i, gradient[2] + i}});
        }
    }
    [[nodiscard]] HWY_INLINE V<double> f_at(std::size_t i) const { return load(f + i); }
    [[nodiscard]] HWY_INLINE Vectors3 gradient_at(std::size_t i) const {
        return {.x = load(gradient[0] + i), .y = load(gradient[1] + i), .z = load(gradient[2] + i)};
    }
};

/// Some rays, as many in a part as batches take at least, of which parts are done one after the
/// other.
template <std::size_t capacity>
class OpenParts {
public:
    explicit OpenParts(std::size_t size) : count_(size / batch_multiple) {
        for (std::size_t i = 0; i < count_; ++i)
            firsts_[i] = i * batch_multiple;
    }
    [[nodiscard]] std::size_t size() const { return count_ * batch_multiple; }
    /// Calls visit(ray, point) for each vector of rays that are not done; a part of which it
    /// returns false for all vectors is.
    template <class Visit>
    HWY_INLINE void keep(const Visit& visit) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < count_; ++k) {
            bool open = false;
            for (std::size_t i = 0; i < batch_multiple; i += lanes<double>)
                open = visit(firsts_[k] + i, k * batch_multiple + i) || open;
            if (open) firsts_[kept++] = firsts_[k];
        }
        count_ = kept;
    }
    template <class Visit>
    HWY_INLINE void for_each(const Visit& visit) const {
        for (std::size_t k = 0; k < count_; ++k) {
            for (std::size_t i = 0; i < batch_multiple; i += lanes<double>)
                visit(firsts_[k] + i, k * batch_multiple + i);
        }
    }

private:
    std::size_t firsts_[capacity / batch_multiple];
    std::size_t count_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
