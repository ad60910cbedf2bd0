#include "engine/appearance/soft_light.hpp"

#include "engine/rays/first_roots.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// A number in [0, 1) that looks random.
double noise(std::uint32_t seed) {
    seed = (seed ^ (seed >> 16U)) * 0x7FEB352DU;
    seed = (seed ^ (seed >> 15U)) * 0x846CA68BU;
    return static_cast<double>(seed ^ (seed >> 16U)) * 0x1p-32;
}

/// A place of the unit disc: the k-th of `count` that are evenly spread over it [Vogel79].
glm::dvec2 disc_place(std::size_t k, std::size_t count, std::uint32_t seed) {
    const double radius =
        std::sqrt((static_cast<double>(k) + noise(2 * seed)) / static_cast<double>(count));
    const double turn = noise(2 * seed + 1) + static_cast<double>(k) * 0.6180339887498949;
    const double angle = 2.0 * glm::pi<double>() * turn;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Two directions across `axis`, all of length 1 and at right angles.
std::array<glm::dvec3, 2> across(const glm::dvec3& axis) {
    const glm::dvec3 aside =
        std::abs(axis.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 a = glm::normalize(glm::cross(axis, aside));
    return {a, glm::cross(axis, a)};
}

/// The part of its rays that is free, of each hit. `directions_of(hit)`: a function from places of
/// the disc to directions; rays that would go into the surface are not free.
template <class Directions>
std::vector<float> free_part(std::span<const TraceFrame> surfaces, std::span<const SoftHit> hits,
                             double reach, const Directions& directions_of, Counters& counters) {
    std::vector<float> parts;
    parts.reserve(hits.size());
    std::vector<SceneRay> rays;
    std::array<std::uint8_t, SoftHit::most_rays> blocked{};
    for (const SoftHit& hit : hits) {
        rays.clear();
        const auto direction = directions_of(hit);
        for (std::size_t k = 0; k < hit.rays; ++k) {
            const glm::dvec3 towards = direction(disc_place(k, hit.rays, hit.seed));
            if (!(glm::dot(towards, hit.normal) > 1e-3)) continue;
            rays.push_back(leaving(hit, towards));
            rays.back().to = reach;
        }
        find_blocked(surfaces, rays, std::span(blocked).first(rays.size()), counters);
        const auto free = std::count(blocked.begin(),
                                     blocked.begin() + static_cast<std::ptrdiff_t>(rays.size()), 0);
        parts.push_back(static_cast<float>(free) / static_cast<float>(hit.rays));
    }
    return parts;
}

}  // namespace

SceneRay leaving(const SoftHit& hit, const glm::dvec3& direction) {
    SceneRay ray = hit.ray;
    ray.direction = UnitVector(direction);
    const double cosine = std::abs(glm::dot(glm::dvec3(ray.direction), hit.normal));
    ray.own_error = hit.error / std::max(cosine, 1e-3);
    const double slope = glm::dot(hit.gradient, direction);
    ray.own_sign = slope > 0.0 ? 1 : slope < 0.0 ? -1 : 0;
    return ray;
}

std::vector<float> broad_light(std::span<const TraceFrame> surfaces, std::span<const SoftHit> hits,
                               const glm::dvec3& towards, double radius_rad, Counters& counters) {
    const std::array<glm::dvec3, 2> aside = across(towards);
    // Even over the cap of the sphere that the light covers.
    const double depth = 1.0 - std::cos(radius_rad);
    const auto direction = [&](const glm::dvec2& place) {
        const double down = depth * glm::dot(place, place);
        const double out = std::sqrt(depth * (2.0 - down));
        return (1.0 - down) * towards + out * (place.x * aside[0] + place.y * aside[1]);
    };
    return free_part(
        surfaces, hits, std::numeric_limits<double>::infinity(),
        [&](const SoftHit& /*hit*/) { return direction; }, counters);
}

std::vector<float> open_sky(std::span<const TraceFrame> surfaces, std::span<const SoftHit> hits,
                            double reach, Counters& counters) {
    const auto directions_of = [](const SoftHit& hit) {
        return [normal = hit.normal, aside = across(hit.normal)](const glm::dvec2& place) {
            const double up = std::sqrt(std::max(1.0 - glm::dot(place, place), 0.0));
            return up * normal + place.x * aside[0] + place.y * aside[1];
        };
    };
    return free_part(surfaces, hits, reach, directions_of, counters);
}

}  // namespace zeroset
