#pragma once

#include "engine/trace/blobs/ray_block.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace zeroset {

/// The result for a stretch of a ray.
enum class BlobWay : std::uint8_t {
    Free,     ///< it meets nothing
    Root,     ///< it meets the surface between its first root's depth and its end
    Unknown,  ///< it may meet something
};

/// A stretch of a parallel ray: to the right and up from the point looked at, and two depths, as
/// TileRays has them; in world units. One that ends before it begins is not looked at.
struct BlobRay {
    double u = 0, v = 0, from = 0, to = -1;
    BlobWay way = BlobWay::Free;  ///< what is found
    double root = 0;              ///< the first root's depth: none is before it
    std::int8_t side = 0;         ///< the sign of f on a free stretch
};

/// Rays that lie together, by place_in_block.
using BlobRays = std::array<BlobRay, ball_block_rays>;

/// Follows blocks of rays through a plain surface of soft balls. `rays`: those of the frame's view,
/// which is parallel. `bracket`: how near to a root rays may end. False, and nothing done: it is
/// no such surface, or places are not known well enough to prove anything. In upward rounding.
bool follow_blob_rays(const TraceFrame& frame, const TileRays& rays, double bracket,
                      std::span<BlobRays> blocks, Counters& counters);

}  // namespace zeroset
