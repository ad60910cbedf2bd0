#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/trace_frame.hpp"

namespace zeroset {

/// Fills in the reflectances of a layer's hits, whose gradients are known, as the scene's coloring
/// says; empties them where it is plain. In upward rounding.
void find_colors(const TraceFrame& frame, const Tile& tile, LitLayer& layer, Counters& counters);

}  // namespace zeroset
