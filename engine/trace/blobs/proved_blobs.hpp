#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

namespace zeroset {

/// Finds and proves the first roots in a tile of a plain surface of soft balls, by those that are
/// near its rays. False, and nothing done, where the surface is none, or the tile is asked for what
/// only beams know: then trace_tile_beams does it. In upward rounding.
bool trace_tile_proved_blobs(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters);

}  // namespace zeroset
