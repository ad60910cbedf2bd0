#pragma once

#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// What leaves wrote down for the rays of a tile: `found`, and the depths in `reach`.
struct TileFound {
    const double* u;  ///< of each column
    const double* v;  ///< of each row
    const double* reach;
    const LeafFound* found;
    double look_distance;
    int cols, rows;
    std::uint64_t blocks;  ///< those with a bit here may have hits
};

/// Tiles are made of blocks of so many rows and columns.
inline constexpr int reach_block = 8;
inline constexpr std::size_t reach_blocks =
    std::size_t{tile_size / reach_block} * (tile_size / reach_block);
static_assert(reach_blocks == 64, "a bit each");

/// The block of a pixel of a tile.
constexpr std::size_t block_of(std::size_t pixel) {
    return pixel / (tile_size * reach_block) * (tile_size / reach_block) +
           pixel % tile_size / reach_block;
}

/// Sets the numbers of all pixels of some blocks.
template <class Number>
void fill_blocks(Number* numbers, std::uint64_t blocks, const Number& number) {
    for (; blocks != 0; blocks &= blocks - 1) {
        const int at = std::countr_zero(blocks);
        constexpr int in_row = tile_size / reach_block;
        Number* row = numbers + at / in_row * reach_block * tile_size + at % in_row * reach_block;
        for (int i = 0; i < reach_block; ++i, row += tile_size)
            std::fill_n(row, reach_block, number);
    }
}

/// Puts the hits of Drawn and Proved rays into a tile's; returns whether there are others: those
/// that are kept elsewhere, or whose normal is no number, which is put all the same.
bool put_found(const TileFound& tile, TileHits& hits);

/// The largest numbers of some blocks of a tile: of those with a bit in `blocks`.
void find_largest(const double* numbers, std::uint64_t blocks,
                  std::array<double, reach_blocks>& largest);

}  // namespace zeroset
