#include "engine/trace/patch/patch_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// Axes with the ray along `forward`, from its origin.
SightAxes axes_along(const PatchRay& ray, double error) {
    const glm::dvec3 size = glm::abs(ray.direction);
    glm::dvec3 aside(0.0);
    aside[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
    const glm::dvec3 right = glm::normalize(glm::cross(ray.direction, aside));
    return {.right = right,
            .up = glm::cross(right, ray.direction),
            .forward = ray.direction,
            .base = ray.origin,
            .distance = 1.0,
            .error = error};
}

}  // namespace

double patch_bias(const TraceFrame& frame) {
    const double size = frame.scene.clip.size();
    const double extent = std::min(size, frame.view.look_distance);
    return std::max(0x1p-12 * extent, 6.0 * std::ldexp(size, -frame.depth.wanted));
}

PatchHit find_patch_hit(const TraceFrame& frame, const PatchRay& ray, bool any,
                        Counters& counters) {
    if (!(ray.from <= ray.to)) return {};
    const PatchTree& tree = tree_of(frame);
    const Box clip = tree.within(frame.scene.clip);
    const PatchQuest quest{.axes = axes_along(ray, place_error(frame)),
                           .ray = {.u = 0.0, .v = 0.0},
                           .from = ray.from,
                           .to = ray.to,
                           .tolerance = std::ldexp(frame.scene.clip.size(), -frame.depth.wanted),
                           .pixel = frame.view.pixel_at_look(frame.image.height),
                           .clip = clip,
                           .any = any};
    return PatchSearch(tree, frame.limit, counters).search(quest, tree.root());
}

PatchHit find_patch_hit(const PatchTree& tree, const PatchRay& ray, double tolerance) {
    constexpr double far = 1e300;
    const Box everywhere = tree.within(Box::cube(far));
    const double reach = std::abs(ray.from) + std::abs(ray.to) + glm::length(ray.origin);
    const PatchQuest quest{.axes = axes_along(ray, 0x1p-48 * reach),
                           .ray = {.u = 0.0, .v = 0.0},
                           .from = ray.from,
                           .to = ray.to,
                           .tolerance = tolerance,
                           .pixel = std::numeric_limits<double>::infinity(),
                           .clip = everywhere};
    const TimeLimit none;
    Counters counters;
    return PatchSearch(tree, none, counters).search(quest, tree.root());
}

}  // namespace zeroset
