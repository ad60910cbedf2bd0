#pragma once

#include "engine/trace/tile.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Tiles are made of blocks of so many rows and columns, one after the other in rows: a bit each.
inline constexpr int tile_block = 8;
inline constexpr std::size_t tile_blocks =
    std::size_t{tile_size / tile_block} * (tile_size / tile_block);
static_assert(tile_blocks == 64);

/// The block of a pixel of a tile; pixels are in rows of tile_size.
constexpr std::size_t block_of(std::size_t pixel) {
    return pixel / (tile_size * tile_block) * (tile_size / tile_block) +
           pixel % tile_size / tile_block;
}

/// The first pixel of a block.
constexpr std::size_t first_pixel_of(std::size_t block) {
    constexpr std::size_t in_row = tile_size / tile_block;
    return block / in_row * tile_block * tile_size + block % in_row * tile_block;
}

/// Visits the first pixel of each row of tile_block pixels in some blocks.
void for_each_block_row(std::uint64_t blocks, auto visit) {
    for (; blocks != 0; blocks &= blocks - 1) {
        std::size_t first = first_pixel_of(static_cast<std::size_t>(std::countr_zero(blocks)));
        for (int row = 0; row < tile_block; ++row, first += tile_size)
            visit(first);
    }
}

}  // namespace zeroset
