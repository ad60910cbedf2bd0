#pragma once

#include "engine/trace/followed_rays.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>

namespace zeroset {

/// The first hits of a parametric surface (PatchCode) in a tile, as Tracer::trace_tile; the
/// frame's `prepared` is a PatchTree. Gradients are dS/du x dS/dv.
void trace_tile_patch(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters);

/// Looks for places of a parametric surface on the rays of a tile's blocks, which are those of the
/// frame's view.
void follow_patch(const TraceFrame& frame, const TileRays& rays, std::span<FollowedRays> blocks,
                  Counters& counters);

}  // namespace zeroset
