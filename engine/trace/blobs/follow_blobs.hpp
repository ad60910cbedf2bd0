#pragma once

#include "engine/trace/followed_rays.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>

namespace zeroset {

/// Follows blocks of rays through a plain surface of soft balls. `rays`: those of the frame's view,
/// which is parallel. `bracket`: how near to a root rays may end. False, and nothing done: it is
/// no such surface, or places are not known well enough to prove anything. In upward rounding.
bool follow_blobs(const TraceFrame& frame, const TileRays& rays, double bracket,
                  std::span<FollowedRays> blocks, Counters& counters);

}  // namespace zeroset
