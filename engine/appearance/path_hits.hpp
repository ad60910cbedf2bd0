#pragma once

#include "engine/trace/scene_ray.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// A ray on its way from the eye, or what it hits.
struct PathRay {
    SceneRay ray;
    std::size_t pixel;         ///< of the tile
    glm::vec3 weight;          ///< of its light in the pixel's
    int mirrors = 0;           ///< that it came by
    float roughness = 0.0F;    ///< of the last of them
    int layers = 0;            ///< translucent surfaces that it passed
    double before = 0.0;       ///< the way from the eye to the ray's origin
    std::uint64_t inside = 0;  ///< solids that it is in: a bit for each of the first 64 surfaces

    [[nodiscard]] bool is_mirrored() const { return mirrors > 0; }
};

/// A hit of such a ray, as far as it is needed to light it.
struct PathHit {
    PathRay path;
    RayHit hit;
    bool is_cap = false;
    bool is_first = false;  ///< seen by the eye itself, and so with known shadows

    [[nodiscard]] glm::dvec3 point() const { return path.ray.at(hit.t); }
    [[nodiscard]] double distance() const { return path.before + hit.t; }
    /// The gradient's direction, on the side that the ray came from; towards there where there is
    /// no gradient.
    [[nodiscard]] glm::dvec3 normal() const;
    /// The direction in which a mirror there sends the ray on.
    [[nodiscard]] glm::dvec3 mirrored() const {
        return glm::reflect(glm::dvec3(path.ray.direction), normal());
    }
};

/// Adds the hits of a surface in a tile to `out`.
void add_first_hits(const TraceFrame& surface, std::uint8_t number, const Tile& tile,
                    const TileHits& hits, std::vector<PathHit>& out);

/// Takes hits of a surface along their rays to the digits of double, where Newton's method leads
/// there: rays that go on from them begin nearer to it.
void sharpen(const TraceFrame& surface, std::span<PathHit> hits, Counters& counters);

}  // namespace zeroset
