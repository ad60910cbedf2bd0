#include "engine/trace/tile_costs.hpp"

#include <algorithm>
#include <cassert>

namespace zeroset {

void TileCosts::begin(const Tile& tile) {
    cols_ = tile.cols;
    rows_ = tile.rows;
    std::ranges::fill(costs_, 0.0);
}

void TileCosts::add(std::size_t pixel, double evaluations) {
    const auto col = static_cast<int>(pixel % tile_size);
    const auto row = static_cast<int>(pixel / tile_size);
    if (col < cols_ && row < rows_) costs_[pixel] += evaluations;
}

void TileCosts::add(int col, int row, int cols, int rows, double evaluations) {
    const int last_col = std::min(col + cols, cols_);
    const int last_row = std::min(row + rows, rows_);
    assert(col < last_col && row < last_row);
    const double share = evaluations / ((last_col - col) * (last_row - row));
    for (int r = row; r < last_row; ++r) {
        for (int c = col; c < last_col; ++c)
            costs_[static_cast<std::size_t>(r * tile_size + c)] += share;
    }
}

}  // namespace zeroset
