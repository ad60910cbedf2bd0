#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <memory>

namespace zeroset {

/// Stolte's octree [Stolte05]; see octree_tracer.cpp.
void trace_tile_octree(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters);
/// Stolte's octree with bounds of the ray that are not rounded outward: nothing is proved.
void trace_tile_octree_unrounded(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                                 Counters& counters);
/// Stolte's octree with Gargantini's traversal: nothing is proved.
void trace_tile_gargantini(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                           Counters& counters);

/// TracerNeeds::prepare of the three: the surface's octree. nullptr where the frame is stopped.
std::shared_ptr<const PreparedSurface> prepare_octree_tracer(const TraceFrame& surface,
                                                             int threads);

}  // namespace zeroset
