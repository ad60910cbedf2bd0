#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

namespace zeroset {

/// K-bisection [Knoll07]; see k_bisection.cpp.
void trace_tile_k_bisection(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                            Counters& counters);

}  // namespace zeroset
