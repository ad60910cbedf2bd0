#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>

namespace zeroset {

class FrameLight;

/// Lights the layers of a tile by all that a look needs: its material, the scene's lights with hard
/// or soft shadows, what mirrors show and what lies behind translucent surfaces, by rays from hit
/// to hit [Whitted80]. Fills in their hit_rows and light. In upward rounding.
void light_paths(const FrameLight& light, std::span<const TraceFrame> surfaces,
                 const TimeLimit& limit, const Tile& tile, std::span<LitLayer> layers,
                 Counters& counters);

}  // namespace zeroset
