#pragma once

#include "engine/light/encode.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/trace/tile.hpp"

#include <span>

namespace zeroset {

/// Copies the light of a tile into Framebuffer::light and the directions of its hits' gradients
/// into Framebuffer::normal, as far as the canvas keeps them. After encode_tile, of the same hits.
void keep_planes(const Tile& tile, std::span<const TileHits> hits, const LitTile& lit,
                 const Canvas& out);

}  // namespace zeroset
