#pragma once

#include "engine/trace/patch/patch_leaf.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"

#include <array>
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
};

/// Puts the hits of Drawn and Proved rays into a tile's; returns whether there are others: those
/// that are kept elsewhere, or whose normal is no number, which is put all the same.
bool put_found(const TileFound& tile, TileHits& hits);

/// Tiles are made of blocks of so many rows and columns.
inline constexpr int reach_block = 8;
inline constexpr std::size_t reach_blocks =
    std::size_t{tile_size / reach_block} * (tile_size / reach_block);

/// The largest numbers of some blocks of a tile: of those with a bit in `blocks`.
void find_largest(const double* numbers, std::uint64_t blocks,
                  std::array<double, reach_blocks>& largest);

}  // namespace zeroset
