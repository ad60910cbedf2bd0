#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <memory>

namespace zeroset {

/// Boxes of the image that beams reject or include, and single rays in what is left; see
/// florez_boxes.cpp.
void trace_tile_florez_boxes(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters);
/// The same with the rejection test alone.
void trace_tile_florez_trimming(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                                Counters& counters);
/// A regular grid walked by beams; see regular_grid.cpp.
void trace_tile_regular_grid(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters);

/// A solid by the roots of its parts; see csg_by_roots.cpp.
void trace_tile_csg_by_roots(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters);
/// Makes the code of the parts. nullptr when stopped.
std::shared_ptr<const PreparedSurface> prepare_csg_parts(const TraceFrame& surface, int threads);

}  // namespace zeroset
