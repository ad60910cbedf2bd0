#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/light/lit_tile.hpp"
#include "engine/trace/tile.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace zeroset {

/// A part of an image.
struct Canvas {
    Framebuffer& pixels;  ///< those from (col, row) on
    int col = 0, row = 0;
    int height = 0;  ///< of the whole image
    /// The bits of the tile to draw in Framebuffer::blank_rows. nullptr: nothing is known.
    std::uint64_t* blank_rows = nullptr;

    [[nodiscard]] std::size_t index(int image_col, int image_row) const {
        return pixels.index(image_col - col, image_row - row);
    }
};

/// Draws a tile of the picture, the last step: each layer's light in 8 bits a channel (gamma 2),
/// with the depths, certificates and surfaces of its hits; elsewhere the background, and Undecided
/// where a ray is unsettled. `hits`: those of all surfaces, with layers or without. In upward
/// rounding.
void encode_tile(const Tile& tile, std::span<const TileHits> hits, const LitTile& lit,
                 const Canvas& out);

}  // namespace zeroset
