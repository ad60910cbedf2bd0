#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <array>
#include <cstddef>

namespace zeroset {

/// Where the hits of a tile are in the view of a light with parallel rays: from the point looked
/// at, to the right, up and along the rays, in world units. Arrays hold one item a pixel, in rows
/// of tile_size.
struct LightPlaces {
    static constexpr std::size_t pixels = std::size_t{tile_size} * tile_size;

    alignas(64) std::array<float, pixels> u, v, s;
    double error = 0.0;  ///< a hit is no farther from its place, in any of the three
};

/// Adds the places of a surface's hits, and finds which of these hits show the light the side that
/// they show the eye. In upward rounding.
TileBits find_places(const TraceFrame& frame, const ViewFrame& light, const Tile& tile,
                     const TileHits& hits, LightPlaces& places);

}  // namespace zeroset
