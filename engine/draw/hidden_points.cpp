#include "engine/draw/hidden_points.hpp"

#include "engine/base/parallel.hpp"
#include "engine/draw/space_function.hpp"
#include "engine/rays/first_roots.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/caps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// How near, in parts of the clip box or of the distance to the point looked at, a surface may come
/// to a point along its ray without hiding it. On a silhouette the ray touches the surface: nearer
/// to that place rounding hides where it is.
constexpr double nearest_part = 0x1p-11;
/// A root that is not proved hides a point only farther from it, in units of `nearest`.
constexpr double unproved_reach = 16.0;
constexpr std::size_t rays_at_once = 64;

}  // namespace

/// The part of a point's ray on which something may hide it.
struct HiddenPoints::Sight {
    SceneRay ray;
    double enters;      ///< where it enters the region
    const Section* by;  ///< the section by which it does so, or nullptr
};

HiddenPoints::HiddenPoints(const Scene& scene, const Page& page, const TimeLimit& limit)
    : scene_(scene),
      page_(page),
      nearest_(nearest_part * std::min(scene.clip.size(), page.view().look_distance)) {
    const ImageSize image{.width = static_cast<int>(page.size().width) + 1,
                          .height = static_cast<int>(page.size().height) + 1};
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        frames_.push_back(trace_frame(scene, scene.surfaces[i], page.view(), image, {}));
        frames_.back().limit = limit;
        solid_signs_.push_back(has_caps(scene) ? solid_sign(scene, i) : 0);
    }
}

HiddenPoints::Sight HiddenPoints::sight_of(const glm::dvec3& point) const {
    const glm::dvec3 direction = page_.ray_direction(point);
    const ViewFrame& view = page_.view();
    const double distance = view.parallel() ? 0.0 : glm::distance(point, view.eye);
    SceneRay ray{.origin = point - distance * direction,
                 .direction = UnitVector(direction),
                 .from = view.parallel() ? -std::numeric_limits<double>::infinity() : 0.0};
    const SceneRay inside = clipped(ray, scene_);
    ray.from = inside.from;
    ray.to = distance - nearest_;
    Sight sight{.ray = ray, .enters = inside.from, .by = nullptr};
    for (const Section& section : scene_.region.sections) {
        const double rate = glm::dot(section.normal, direction);
        const double height = glm::dot(section.normal, ray.origin) - section.offset;
        if (section.cap && rate < 0.0 && std::abs(height / -rate - inside.from) < 1e-3 * nearest_)
            sight.by = &section;
    }
    return sight;
}

/// Whether the ray enters a solid that a section cuts open.
bool HiddenPoints::is_capped(const Sight& sight) const {
    if (sight.by == nullptr || !(sight.enters < sight.ray.to)) return false;
    const glm::dvec3 entry = sight.ray.at(sight.enters);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        const double f = value_at(scene_.surfaces[i].kernel, scene_.uniforms, entry).value;
        if (f * solid_signs_[i] > 0.0) return true;
    }
    return false;
}

void HiddenPoints::find_some(std::span<const glm::dvec3> points,
                             std::span<std::uint8_t> hidden) const {
    std::vector<SceneRay> rays;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Sight sight = sight_of(points[i]);
        rays.push_back(sight.ray);
        hidden[i] = is_capped(sight) ? 1 : 0;
    }
    std::vector<RayHit> hits(rays.size());
    Counters counters;
    {
        const UpwardRounding upward;
        find_first_hits(frames_, rays, hits, counters);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!hits[i].is_hit()) continue;
        const bool is_proved = hits[i].certificate == Certificate::Certified;
        const double before = rays[i].to - hits[i].t;
        if (is_proved || before > unproved_reach * nearest_) hidden[i] = 1;
    }
}

void HiddenPoints::find(std::span<const glm::dvec3> points, std::span<std::uint8_t> hidden) const {
    const std::size_t chunks = (points.size() + rays_at_once - 1) / rays_at_once;
    parallel_for(chunks, 0, [&](std::size_t chunk) {
        const std::size_t first = chunk * rays_at_once;
        const std::size_t count = std::min(rays_at_once, points.size() - first);
        find_some(points.subspan(first, count), hidden.subspan(first, count));
    });
}

bool HiddenPoints::is_hidden(const glm::dvec3& point) const {
    std::uint8_t hidden = 0;
    find_some({&point, 1}, {&hidden, 1});
    return hidden != 0;
}

}  // namespace zeroset
