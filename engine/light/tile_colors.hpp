#pragma once

#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>

namespace zeroset {

/// Fills in the reflectances of a surface's hits, whose gradients are known, as the scene's
/// coloring says; empties them where it is plain. In upward rounding.
void find_colors(const TraceFrame& frame, std::size_t surface, const Tile& tile, TileHits& hits,
                 Counters& counters);

}  // namespace zeroset
