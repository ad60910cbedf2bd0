#pragma once

#include "engine/view/image_point.hpp"

#include <cstddef>

namespace zeroset {

inline constexpr int tile_size = 64;
inline constexpr std::size_t tile_pixels = std::size_t{tile_size} * tile_size;

/// Index of a pixel of a tile in arrays that hold its rows one after the other.
constexpr std::size_t pixel_index(int col, int row) {
    return static_cast<std::size_t>(row * tile_size + col);
}

/// Where in the image rays go that pass pixels elsewhere than in their centres: for each pixel of a
/// tile, in rows of tile_size, in pixels to the right of the centre of the tile's first pixel, and
/// downwards. They need not even be in the pixel.
struct RayPlaces {
    const float* col;
    const float* row;
};

/// A rectangle of the image, at most tile_size wide and high.
struct Tile {
    int col, row;  ///< its first pixel
    int cols, rows;
    /// For each pixel, in rows of tile_size, the distance from the eye beyond which nothing is
    /// wanted: a tracer may leave out what is farther. nullptr: all is wanted.
    const float* limits = nullptr;
    const RayPlaces* places = nullptr;  ///< nullptr: rays pass the pixels' centres

    /// Where the ray of a pixel of the tile passes the image.
    [[nodiscard]] PixelPoint place(int pixel_col, int pixel_row) const {
        const PixelPoint centre = pixel_centre(col + pixel_col, row + pixel_row);
        if (places == nullptr) return centre;
        const auto at = static_cast<std::size_t>(pixel_row * tile_size + pixel_col);
        const PixelPoint first = pixel_centre(col, row);
        return {.col = first.col + static_cast<double>(places->col[at]),
                .row = first.row + static_cast<double>(places->row[at])};
    }
};

}  // namespace zeroset
