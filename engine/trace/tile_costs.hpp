#pragma once

#include "engine/trace/tile.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// The cost of each pixel of a tile: evaluations of f, of its ranges and of its forms, each shared
/// out over the pixels that it was for. One for each thread.
class TileCosts {
public:
    TileCosts() : costs_(std::size_t{tile_size} * tile_size) {}

    /// Forgets what was.
    void begin(const Tile& tile);
    /// Adds evaluations for a pixel, an index in rows of tile_size; for none outside the tile.
    void add(std::size_t pixel, double evaluations = 1.0);
    /// Adds evaluations for a rectangle of pixels from (col, row) on; its pixels in the tile,
    /// of which there must be one, pay for those outside.
    void add(int col, int row, int cols, int rows, double evaluations = 1.0);

    /// The costs of the first `cols` pixels of a row of the tile.
    [[nodiscard]] std::span<const double> row(int row, int cols) const {
        return std::span(costs_).subspan(static_cast<std::size_t>(row) * tile_size,
                                         static_cast<std::size_t>(cols));
    }

private:
    int cols_ = 0, rows_ = 0;
    std::vector<double> costs_;
};

}  // namespace zeroset
