#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

namespace zeroset {

/// Beams: cells of a tile of pixels times a slab of depth, then one certified root a ray; see
/// beam_tracer.cpp.
void trace_tile_beams(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters);

}  // namespace zeroset
