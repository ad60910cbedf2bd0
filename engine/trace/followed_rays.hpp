#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/tile_blocks.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace zeroset {

/// The finding on a stretch of a ray.
enum class RayFinding : std::uint8_t {
    Free,     ///< it meets nothing
    Root,     ///< it meets the surface
    Unknown,  ///< it may meet something
};

/// A stretch of a parallel ray: to the right and up from the point looked at, and two depths, as
/// TileRays has them; in world units. One that ends before it begins is not looked at.
struct FollowedRay {
    double u = 0, v = 0, from = 0, to = -1;
    RayFinding found = RayFinding::Free;
    /// A depth before which there is no root of a level set; its first one is between there and
    /// `to`.
    double root = 0;
    std::int8_t side = 0;  ///< the sign of f on a free stretch; of a level set
};

inline constexpr int ray_block_side = tile_block;
inline constexpr std::size_t ray_block_rays = 64;

/// The place of a ray of a block among its numbers: neighbours in the image are neighbours there,
/// so that whole vectors of rays are as square as can be.
constexpr std::size_t place_in_block(int col, int row) {
    std::size_t place = 0;
    for (unsigned bit = 0; bit < 3; ++bit) {
        place |= (static_cast<unsigned>(col) >> bit & 1U) << (2 * bit);
        place |= (static_cast<unsigned>(row) >> bit & 1U) << (2 * bit + 1);
    }
    return place;
}

/// Rays that lie together, by place_in_block.
using FollowedRays = std::array<FollowedRay, ray_block_rays>;

/// The ray of a pixel, where there is one for each in the blocks of a tile.
inline FollowedRay& ray_of(std::span<FollowedRays> blocks, std::size_t pixel) {
    const auto col = static_cast<int>(pixel % tile_size);
    const auto row = static_cast<int>(pixel / tile_size);
    return blocks[block_of(pixel)][place_in_block(col % ray_block_side, row % ray_block_side)];
}

}  // namespace zeroset
