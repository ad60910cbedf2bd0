#pragma once

#include "engine/trace/tile.hpp"

#include <algorithm>
#include <cstddef>

namespace zeroset {

/// The tiles of an image, row by row.
class TileGrid {
public:
    TileGrid(int width, int height)
        : width_(width), height_(height), columns_((width + tile_size - 1) / tile_size) {}

    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(columns_) *
               static_cast<std::size_t>((height_ + tile_size - 1) / tile_size);
    }
    [[nodiscard]] Tile tile(std::size_t index) const {
        const int col = static_cast<int>(index) % columns_ * tile_size;
        const int row = static_cast<int>(index) / columns_ * tile_size;
        return {.col = col,
                .row = row,
                .cols = std::min(tile_size, width_ - col),
                .rows = std::min(tile_size, height_ - row)};
    }
    /// The index of the tile that holds a pixel.
    [[nodiscard]] std::size_t index_of(int col, int row) const {
        return static_cast<std::size_t>(row / tile_size * columns_ + col / tile_size);
    }

private:
    int width_, height_, columns_;
};

}  // namespace zeroset
