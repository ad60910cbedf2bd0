#pragma once

#include "engine/trace/tracer.hpp"

#include <cstdint>

namespace zeroset {

/// Background and misses in the whole tile.
void clear_tile(const Tile& tile, Framebuffer& out);

/// Two-sided shading by the gradient, in the colours of surface number `surface`: front where the
/// viewer stands on the side f > 0, back on the other. Writes the hits of the surface, and
/// Undecided where a ray is unsettled on pixels that are still misses; the rest of the tile stays.
void shade_tile(const TraceFrame& frame, std::uint8_t surface, const Tile& tile,
                const TileHits& hits, Framebuffer& out);

/// The background of an image row, RGBA.
std::uint32_t background_color(int row, int height);

}  // namespace zeroset
