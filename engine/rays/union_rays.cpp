#include "engine/rays/union_rays.hpp"

#include "engine/kernel/specializer.hpp"
#include "engine/trace/frame_union.hpp"

#include <algorithm>
#include <limits>

namespace zeroset {
namespace {

/// The box that holds all rays, as far as they go.
Box box_about(std::span<const SceneRay> rays) {
    Box box{.lo = glm::dvec3(std::numeric_limits<double>::infinity()),
            .hi = glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (const SceneRay& ray : rays) {
        if (!(ray.from < ray.to)) continue;
        for (const double t : {ray.from, ray.to}) {
            box.lo = glm::min(box.lo, ray.at(t));
            box.hi = glm::max(box.hi, ray.at(t));
        }
    }
    return box;
}

bool overlap(const Box& a, const Box& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y &&
           a.lo.z <= b.hi.z && b.lo.z <= a.hi.z;
}

Box widened(const Box& box, double by) { return {.lo = box.lo - by, .hi = box.hi + by}; }

/// Cuts a ray down to what of it is in the box; whether anything is. Boxes are so much wider than
/// their parts that rounding here does not matter.
bool cut(SceneRay& ray, const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = ray.direction[axis];
        const double lo = box.lo[axis] - ray.origin[axis];
        const double hi = box.hi[axis] - ray.origin[axis];
        if (rate == 0.0) {
            if (lo > 0.0 || hi < 0.0) return false;
            continue;
        }
        ray.from = std::max(ray.from, std::min(lo / rate, hi / rate));
        ray.to = std::min(ray.to, std::max(lo / rate, hi / rate));
    }
    return ray.from <= ray.to;
}

}  // namespace

UnionRays::UnionRays(const TraceFrame& surface, std::uint8_t number, std::span<const SceneRay> rays)
    : number_(number), spare_(4 * place_error(surface)) {
    const Scene& scene = surface.scene;
    const Specializer* const specializer = surface.kernel.specializer.get();
    const UnionParts* const parts = specializer == nullptr ? nullptr : specializer->union_parts();
    if (parts == nullptr || !scene.region.is_whole()) return;
    reaches_ = parts->reaches(reach_box(scene.clip), scene.uniforms);
    const Box about = box_about(rays);
    for (std::size_t i = 0; i < reaches_->size(); ++i) {
        const Reach& reach = (*reaches_)[i];
        if (!reach.any) continue;
        if (!reach.continuous) return;
        const Box box = widened(box_of(reach.box), spare_);
        if (overlap(box, about)) members_.push_back({.kernel = parts->kernels()[i], .box = box});
    }
    known_ = true;
}

bool UnionRays::begins_outside(const SceneRay& ray) const {
    if (ray.own == number_) return ray.own_sign > 0;
    const glm::dvec3 start = ray.at(ray.from);
    const Box here{.lo = start, .hi = start};
    return std::ranges::none_of(members_,
                                [&](const Member& member) { return overlap(member.box, here); });
}

bool UnionRays::list(const SceneRay& ray, std::vector<Meeting>& meetings) const {
    meetings.clear();
    if (!known_ || !begins_outside(ray)) return false;
    const double start = ray.from + 2.0 * ray.own_error + spare_;
    for (const Member& member : members_) {
        SceneRay stretch = ray;
        if (!cut(stretch, member.box)) continue;
        const bool at_start = stretch.from <= start;
        if (at_start) stretch.from = ray.from;
        meetings.push_back({.kernel = member.kernel, .stretch = stretch, .at_start = at_start});
    }
    return true;
}

}  // namespace zeroset
