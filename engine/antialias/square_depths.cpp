#include "engine/antialias/square_depths.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/antialias/square_depths.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/antialias/ray_values-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// TileRays::depths for squares seen in perspective, in a clip box.
class BoxDepths {
public:
    BoxDepths(const TileRays& rays, double radius)
        : rays_(rays), view_(rays.axes()), clip_(rays.clip()), radius_(radius) {}

    HWY_INLINE void find(SquareDepths& squares, std::size_t i) const {
        const V<double> none = hn::Inf(d<double>);
        Crossing all{.enter_lo = hn::Zero(d<double>),
                     .enter_hi = hn::Zero(d<double>),
                     .exit_lo = none,
                     .exit_hi = none};
        const V<double> u = load(&squares.u[i]);
        const V<double> v = load(&squares.v[i]);
        for (int axis = 0; axis < 3; ++axis) {
            const Crossing range = between_planes(axis, u, v);
            all = {.enter_lo = hn::Max(all.enter_lo, range.enter_lo),
                   .enter_hi = hn::Max(all.enter_hi, range.enter_hi),
                   .exit_lo = hn::Min(all.exit_lo, range.exit_lo),
                   .exit_hi = hn::Min(all.exit_hi, range.exit_hi)};
        }
        const V<double> eye = number(view_.look_distance);
        const V<double> error = number(rays_.depth_error());
        store(hn::Sub(hn::Sub(all.enter_lo, eye), error), &squares.enter_lo[i]);
        store(hn::Add(hn::Sub(all.enter_hi, eye), error), &squares.enter_hi[i]);
        store(hn::Sub(hn::Sub(all.exit_lo, eye), error), &squares.exit_lo[i]);
        store(hn::Add(hn::Sub(all.exit_hi, eye), error), &squares.exit_hi[i]);
    }

private:
    struct Crossing {
        V<double> enter_lo, enter_hi, exit_lo, exit_hi;
    };

    /// Where the rays are between the planes of the box across an axis.
    [[nodiscard]] HWY_INLINE Crossing between_planes(int axis, V<double> u, V<double> v) const {
        const V<double> zero = hn::Zero(d<double>);
        const V<double> none = hn::Inf(d<double>);
        const double to_lo = clip_.lo[axis] - view_.eye[axis];
        const double to_hi = clip_.hi[axis] - view_.eye[axis];
        const V<double> middle =
            hn::Add(hn::Add(number(view_.forward[axis]), hn::Mul(u, number(view_.right[axis]))),
                    hn::Mul(v, number(view_.up[axis])));
        const V<double> across = number(std::abs(view_.right[axis]) * radius_ +
                                        std::abs(view_.up[axis]) * radius_ + 0x1p-48);
        const V<double> d0 = hn::Sub(middle, across);
        const V<double> d1 = hn::Add(middle, across);
        // All rays run to the same side of the axis.
        const M<double> forward = hn::Gt(d0, zero);
        const V<double> near = hn::IfThenElse(forward, number(to_lo), number(to_hi));
        const V<double> far = hn::IfThenElse(forward, number(to_hi), number(to_lo));
        const V<double> per_d0 = hn::Div(number(1.0), d0);
        const V<double> per_d1 = hn::Div(number(1.0), d1);
        const V<double> near_0 = hn::Mul(near, per_d0);
        const V<double> near_1 = hn::Mul(near, per_d1);
        const V<double> far_0 = hn::Mul(far, per_d0);
        const V<double> far_1 = hn::Mul(far, per_d1);
        Crossing range{.enter_lo = hn::Min(near_0, near_1),
                       .enter_hi = hn::Max(near_0, near_1),
                       .exit_lo = hn::Min(far_0, far_1),
                       .exit_hi = hn::Max(far_0, far_1)};
        const M<double> both = hn::And(hn::Le(d0, zero), hn::Ge(d1, zero));
        if (hn::AllFalse(d<double>, both)) return range;
        // Some run to either side: between the planes for a while if the eye is, else perhaps
        // never.
        const bool inside = to_lo < 0.0 && 0.0 < to_hi;
        const V<double> steepest =
            hn::Max(hn::Max(hn::Neg(d0), d1), number(std::numeric_limits<double>::min()));
        const V<double> first = hn::Div(number(std::min(to_hi, -to_lo)), steepest);
        range.enter_lo = hn::IfThenElse(both, hn::Neg(none), range.enter_lo);
        range.enter_hi = hn::IfThenElse(both, inside ? zero : none, range.enter_hi);
        range.exit_lo = hn::IfThenElse(both, inside ? first : hn::Neg(none), range.exit_lo);
        range.exit_hi = hn::IfThenElse(both, none, range.exit_hi);
        return range;
    }

    const TileRays& rays_;
    const ViewFrame& view_;
    const Box& clip_;
    double radius_;
};

void depths_in_box(const TileRays& rays, double radius, std::size_t count, SquareDepths& squares) {
    const BoxDepths box(rays, radius);
    for (std::size_t i = count; i % lanes<double> != 0; ++i) {
        squares.u[i] = squares.u[count - 1];
        squares.v[i] = squares.v[count - 1];
    }
    for (std::size_t i = 0; i < count; i += lanes<double>)
        box.find(squares, i);
}

void depths_of_hits(const TileRays& rays, std::size_t count, SquareDepths& squares) {
    const V<double> one = number(1.0);
    for (std::size_t i = 0; i < count; i += lanes<double>) {
        const V<double> u = load(&squares.u[i]);
        const V<double> v = load(&squares.v[i]);
        const V<double> square = hn::Add(hn::Add(one, hn::Mul(u, u)), hn::Mul(v, v));
        const V<double> along = hn::Div(load(&squares.hit[i]), hn::Sqrt(square));
        store(hn::Sub(along, number(rays.look_distance())), &squares.hit[i]);
    }
}

/// TileRays::stretch_inside for some rays, as many as vectors are long at most.
void clip_in_box(const TileRays& rays, std::span<RayStretch> stretches) {
    constexpr double flat = 1e-270;  // rays less steep than this stay where they are
    const ViewFrame& view = rays.axes();
    alignas(64) double u[lanes<double>], v[lanes<double>], from[lanes<double>], to[lanes<double>];
    for (std::size_t i = 0; i < lanes<double>; ++i) {
        const RayStretch& stretch = stretches[std::min(i, stretches.size() - 1)];
        u[i] = rays.u(stretch.col);
        v[i] = rays.v(stretch.row);
        from[i] = stretch.from;
        to[i] = stretch.to;
    }
    V<double> first = hn::Zero(d<double>);
    V<double> last = hn::Inf(d<double>);
    for (int axis = 0; axis < 3; ++axis) {
        const V<double> along =
            hn::Add(hn::Add(number(view.forward[axis]), hn::Mul(load(u), number(view.right[axis]))),
                    hn::Mul(load(v), number(view.up[axis])));
        const M<double> steep = hn::Gt(hn::Abs(along), number(flat));
        const V<double> least = hn::CopySign(number(flat), along);
        const V<double> per_depth = hn::Div(number(1.0), hn::IfThenElse(steep, along, least));
        const V<double> lo = hn::Mul(number(rays.clip().lo[axis] - view.eye[axis]), per_depth);
        const V<double> hi = hn::Mul(number(rays.clip().hi[axis] - view.eye[axis]), per_depth);
        first = hn::Max(first, hn::Min(lo, hi));
        last = hn::Min(last, hn::Max(lo, hi));
    }
    const V<double> eye = number(view.look_distance);
    store(hn::Max(load(from), hn::Sub(first, eye)), from);
    store(hn::Min(load(to), hn::Sub(last, eye)), to);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        stretches[i].from = from[i];
        stretches[i].to = to[i];
    }
}

void clip_all_in_box(const TileRays& rays, std::span<RayStretch> stretches) {
    for (std::size_t i = 0; i < stretches.size(); i += lanes<double>)
        clip_in_box(rays, stretches.subspan(i, std::min(lanes<double>, stretches.size() - i)));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(depths_in_box);
HWY_EXPORT(depths_of_hits);
HWY_EXPORT(clip_all_in_box);

bool is_plain_box(const TileRays& rays) {
    return !rays.axes().parallel() && rays.region().is_whole();
}

}  // namespace

void find_depths(const TileRays& rays, double radius, std::size_t count, SquareDepths& squares) {
    if (is_plain_box(rays))
        return HWY_DYNAMIC_DISPATCH(depths_in_box)(rays, radius, count, squares);
    for (std::size_t i = 0; i < count; ++i) {
        const DepthRange range = rays.depths(squares.u[i], squares.v[i], radius, radius);
        squares.enter_lo[i] = range.enter_lo;
        squares.enter_hi[i] = range.enter_hi;
        squares.exit_lo[i] = range.exit_lo;
        squares.exit_hi[i] = range.exit_hi;
    }
}

void find_hits(const TileRays& rays, std::size_t count, SquareDepths& squares) {
    HWY_DYNAMIC_DISPATCH(depths_of_hits)(rays, count, squares);
}

void clip_stretches(const TileRays& rays, std::span<RayStretch> stretches) {
    if (is_plain_box(rays)) return HWY_DYNAMIC_DISPATCH(clip_all_in_box)(rays, stretches);
    for (RayStretch& stretch : stretches) {
        const TileRays::Stretch inside =
            rays.stretch_inside(rays.u(stretch.col), rays.v(stretch.row));
        stretch.from = std::max(stretch.from, inside.from);
        stretch.to = std::min(stretch.to, inside.to);
    }
}

}  // namespace zeroset

#endif
