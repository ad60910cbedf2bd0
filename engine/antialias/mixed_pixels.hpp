#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_rays.hpp"

#include <span>
#include <vector>

namespace zeroset {

/// Adds to `out` the pixels of a tile of which the surfaces' hits do not tell that one smooth sheet
/// covers them, or nothing; all of them where a tracer says nothing of whole pixels. `layers`: the
/// hits as they look.
void find_mixed(const Tile& tile, std::span<const LitLayer> layers, std::span<const TileHits> hits,
                std::vector<MixedPixel>& out);

/// Adds pixels beside which the shadow on the same surface begins or ends to `mixed`, those of one
/// tile; `contrasts`: and those beside which it looks different, as where mirrors show an edge.
/// They are divided until samples tell how much of them the light reaches.
void add_light_edges(const Tile& tile, const TileRays& rays, std::span<const LitLayer> layers,
                     std::span<const TileHits> hits, bool contrasts,
                     std::vector<MixedPixel>& mixed);

/// The pixels of `wanted` that look like the eight pixels around them, all of them hits of one
/// surface, all in the tile: what lies between these is nearly of their colour.
TileBits calm_pixels(const Tile& tile, std::span<const LitLayer> layers, const TileBits& wanted);

}  // namespace zeroset
