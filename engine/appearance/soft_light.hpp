#pragma once

#include "engine/trace/scene_ray.hpp"
#include "engine/trace/trace_frame.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// A hit of which light is asked for that comes from many directions.
struct SoftHit {
    static constexpr std::size_t most_rays = 16;

    SceneRay ray;                  ///< from the hit, in any direction; without an end
    glm::dvec3 normal;             ///< of length 1, on the side that is seen
    double error;                  ///< how far the surface may be from ray.origin, along the normal
    std::uint32_t seed;            ///< hits of one seed take the same directions
    std::size_t rays = most_rays;  ///< to be sent; more tell it better
    glm::dvec3 gradient{0.0};      ///< of the surface's f
};

/// The part of a broad light that reaches each hit, 0 to 1, by rays to places spread over its disc:
/// those of every hit turned otherwise.
std::vector<float> broad_light(std::span<const TraceFrame> surfaces, std::span<const SoftHit> hits,
                               const glm::dvec3& towards, double radius_rad, Counters& counters);

/// The part of all directions over each hit, weighted by their cosines, in which nothing is nearer
/// than `reach`, 0 to 1.
std::vector<float> open_sky(std::span<const TraceFrame> surfaces, std::span<const SoftHit> hits,
                            double reach, Counters& counters);

/// A ray from a place on a surface, which leaves it at this angle's cosine to the normal.
SceneRay leaving(const SoftHit& hit, const glm::dvec3& direction);

}  // namespace zeroset
