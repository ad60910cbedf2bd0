#pragma once

#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/blobs/near_balls.hpp"
#include "engine/trace/blobs/ray_block.hpp"
#include "engine/trace/tile_rays.hpp"

#include <cstdint>
#include <vector>

namespace zeroset {

/// The balls of a slab, and those of them that some rays may meet.
struct SlabBalls {
    NearBalls near;
    BallColumns columns;
    std::vector<std::uint32_t> listed;
    std::vector<ViewBall> balls;

    /// Lists the slab's balls that may reach the rays within the radii of (u, v) between two
    /// depths; whether these may bring f to the level. `tail`: how far f is from the sum of balls,
    /// at most.
    bool list(const BlobSurface& surface, double tail, const TileRays& rays, BlockBeam beam);
};

}  // namespace zeroset
