#include "engine/trace/scene_ray.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

void make_empty(SceneRay& ray) { ray.to = -std::numeric_limits<double>::infinity(); }

/// Keeps the points at which dot(normal, p) <= offset.
void cut(SceneRay& ray, const glm::dvec3& normal, double offset) {
    const double height = glm::dot(normal, ray.origin) - offset;
    const double rate = glm::dot(normal, glm::dvec3(ray.direction));
    if (rate > 0.0) {
        ray.to = std::min(ray.to, -height / rate);
    } else if (rate < 0.0) {
        ray.from = std::max(ray.from, height / -rate);
    } else if (height > 0.0) {
        make_empty(ray);
    }
}

void cut(SceneRay& ray, const Ball& ball) {
    const glm::dvec3 from = ray.origin - ball.centre;
    const double nearest = -glm::dot(from, glm::dvec3(ray.direction));
    const double gap = glm::length(from + nearest * ray.direction);
    if (gap > ball.radius) return make_empty(ray);
    const double half = std::sqrt((ball.radius - gap) * (ball.radius + gap));
    ray.from = std::max(ray.from, nearest - half);
    ray.to = std::min(ray.to, nearest + half);
}

}  // namespace

SceneRay clipped(const SceneRay& ray, const Scene& scene) {
    SceneRay inside = ray;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        cut(inside, axis, scene.clip.hi[i]);
        cut(inside, -axis, -scene.clip.lo[i]);
    }
    for (const Section& section : scene.region.sections)
        cut(inside, section.normal, section.offset);
    if (scene.region.ball) cut(inside, *scene.region.ball);
    return inside;
}

}  // namespace zeroset
