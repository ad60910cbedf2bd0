#pragma once

#include "engine/light/light_places.hpp"
#include "engine/light/light_walls.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace zeroset {

/// The question which hits of a tile lie in the shadow of one surface.
struct ShadowSearch {
    const TraceFrame& light;  ///< the surface in the light's view
    const TileRays& rays;     ///< those of the light
    const LightWalls& walls;  ///< which these pass
    const LightPlaces& places;
    TileBits open;          ///< hits that are asked about
    const TileBits& roots;  ///< those of them that are roots of the surface's own function
    bool is_member;         ///< of a union: then those are places at which f is 0 or above
    double finest;          ///< a cell of a ray that is no longer is not divided
    /// From a hit that its surface only touches the search begins so far in front of it.
    double bias;
    bool singly;  ///< by single rays alone

    /// This question about some of the hits, by another kernel in the light's view.
    [[nodiscard]] ShadowSearch with(const TraceFrame& other, const TileBits& hits) const {
        return {.light = other,
                .rays = rays,
                .walls = walls,
                .places = places,
                .open = hits,
                .roots = roots,
                .is_member = is_member,
                .finest = finest,
                .bias = bias,
                .singly = singly};
    }
};

/// The sign of f at a place on its way to the light.
enum class RaySign : std::int8_t { Negative = -1, Unknown = 0, Positive = 1 };

/// The ray from a hit to the light, as far as it is not searched yet.
struct LightRay {
    std::size_t pixel;
    double u, v;      ///< of the ray in the light's view, as TileRays has them
    double s;         ///< depth of the hit
    double from, to;  ///< depths between which there may be a root
    bool left;        ///< a root in front of `to` is another one than the hit; else it may be it
    RaySign sign;     ///< of f at `to`, if the hit is left
    bool is_root;     ///< the hit is one of ShadowSearch::roots
};

/// Searches by beams: the rays from squares of pixels to the light at once, divided until each
/// square is lit, in the shadow, or single rays, which are added to `rest`. In upward rounding.
void search_beams(const ShadowSearch& search, ShadowBits& found, std::vector<LightRay>& rest,
                  Counters& counters);

/// Searches single rays. In upward rounding.
void search_rays(const ShadowSearch& search, const std::vector<LightRay>& rays, ShadowBits& found,
                 Counters& counters);

/// Searches the ways to the light as the surface's kind follows rays (SurfaceWay::follow): of a
/// level set from where they enter what is visible to its hits, and by single rays only from these
/// to where those begin, and what is left. False, and nothing done: its kind does not. In upward
/// rounding.
bool find_followed_shadows(const ShadowSearch& search, ShadowBits& found, Counters& counters);

/// The surface's kernel for all that lies between the light and the hits that are asked about, all
/// in a square of the tile; nullptr where it would not be shorter. It outlives no kernel that it is
/// made from. In upward rounding.
std::shared_ptr<const Kernel> kernel_before_hits(const ShadowSearch& search, const Square& square);

}  // namespace zeroset
