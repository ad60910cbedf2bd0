#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/trace_frame.hpp"

namespace zeroset {

/// Gives a layer's hits on sections that show values the colours of these (Scene::section_values),
/// unlit, and the surface's colour where f = 0: a line of some 1.5 pixels of the picture.
/// `fineness`: pixels across one of the picture. In upward rounding.
void show_section_values(const TraceFrame& frame, const Tile& tile, int fineness, LitLayer& layer,
                         Counters& counters);

}  // namespace zeroset
