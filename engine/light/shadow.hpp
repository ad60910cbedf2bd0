#pragma once

#include "engine/light/lit_tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>

namespace zeroset {

/// Where the light is that throws shadows: towards the key light (shade.hpp) from the point looked
/// at, so far that its rays are nearly parallel.
glm::dvec3 shadow_light(const ViewFrame& view, const Box& clip);

/// Finds which hits of a tile's layers the key light does not reach, by enclosures along the paths
/// to it [Knoll07, Florez08]: nothing that throws a shadow is missed, however thin. Their gradients
/// are known. What is not found within `limit` is lit. In upward rounding.
void find_shadows(std::span<const TraceFrame> surfaces, const TimeLimit& limit, const Tile& tile,
                  std::span<LitLayer> layers, Counters& counters);

}  // namespace zeroset
