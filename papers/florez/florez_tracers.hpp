#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <memory>

namespace zeroset {

/// Boxes of the image that beams reject or include, and single rays in what is left; see
/// florez_boxes.cpp.
void trace_tile_florez_boxes(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters);
/// Boxes of the image by the rejection test alone, and single rays in what is left.
void trace_tile_florez_trimming(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                                Counters& counters);
/// A regular grid walked by beams; see regular_grid.cpp.
void trace_tile_regular_grid(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters);

}  // namespace zeroset
