#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

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

/// Draws a tile of the picture: what was hit of each surface (hits[i] of surface i; no pixel is hit
/// in two), by two-sided shading with the gradient in the surface's colours: front where the viewer
/// stands on the side f > 0, back on the other; or in the reflectances of the hits' own. Elsewhere
/// the background, and Undecided where a ray is unsettled.
void draw_tile(std::span<const TraceFrame> surfaces, std::span<const TileHits> hits,
               const Tile& tile, const Canvas& out);

/// Towards the light that makes highlights and shadows, which moves with the camera. Length 1.
glm::dvec3 key_light(const ViewFrame& view);

/// The background of an image row, RGBA.
std::uint32_t background_color(int row, int height);

}  // namespace zeroset
