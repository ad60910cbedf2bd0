#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/tile.hpp"

#include <span>

namespace zeroset {

/// The pixels of `wanted` that look like the eight pixels around them, all of them hits of one
/// surface, all in the tile: what lies between these is nearly of their colour.
TileBits calm_pixels(const Tile& tile, std::span<const LitLayer> layers, const TileBits& wanted);

}  // namespace zeroset
