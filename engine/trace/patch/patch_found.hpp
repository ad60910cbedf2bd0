#pragma once

#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_blocks.hpp"
#include "engine/trace/tile_hits.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// The hits that leaves found on the rays of a tile: `found`, with their depths in `reach`.
struct TileFound {
    const double* u;  ///< of each column
    const double* v;  ///< of each row
    const double* reach;
    const LeafFound* found;
    double look_distance;
    int cols, rows;
    std::uint64_t blocks;  ///< those with a bit here may have hits
};

/// Sets the numbers of all pixels of some blocks.
template <class Number>
void fill_blocks(Number* numbers, std::uint64_t blocks, const Number& number) {
    for_each_block_row(
        blocks, [&](std::size_t first) { std::fill_n(numbers + first, tile_block, number); });
}

/// Puts the hits of Drawn and Proved rays into a tile's; returns whether there are others: those
/// that are kept elsewhere, or whose normal is no number, which is put all the same.
bool put_found(const TileFound& tile, TileHits& hits);

/// The largest number of each block of a tile that has a bit in `blocks`.
void find_largest(const double* numbers, std::uint64_t blocks,
                  std::array<double, tile_blocks>& largest);

}  // namespace zeroset
