#pragma once

namespace zeroset {

inline constexpr int tile_size = 64;

/// A rectangle of the image, at most tile_size wide and high.
struct Tile {
    int col, row;  ///< its first pixel
    int cols, rows;
    /// For each pixel, in rows of tile_size, the distance from the eye beyond which nothing is
    /// wanted: a tracer may leave out what is farther. nullptr: all is wanted.
    const float* limits = nullptr;
};

}  // namespace zeroset
