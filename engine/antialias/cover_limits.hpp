#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <vector>

namespace zeroset {

/// Narrows `limits`, those of Tile for whole pixels, by a surface's hits: behind a sheet that
/// covers all of a pixel nothing of it is seen. Behind a hit of its ray alone something may be,
/// beside it. In upward rounding.
void narrow_limits(const TraceFrame& surface, const Tile& tile, const TileHits& hits,
                   std::vector<float>& limits);

}  // namespace zeroset
