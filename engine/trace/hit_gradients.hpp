#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

namespace zeroset {

/// Fills in the gradients of those of `hits.points` that are still hits: in double, of the branch
/// of f that vanishes there, against the ray where f falls along it. Where the gradient vanishes or
/// is none, it is that of a point nearby, or of differences; against the ray where the search was
/// stopped.
void find_gradients(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters);

}  // namespace zeroset
