#pragma once

#include "engine/trace/scene_ray.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

// First roots on single rays that go anywhere: mirrored ones, those behind a translucent surface,
// those to a light. Beams of pixels (engine/trace/beam) are far quicker for rays that go together.

/// The first root of any surface on each ray, within the clip box and the region. Of equal
/// distances the first surface. Surfaces' caps are not seen: rays that begin inside the region
/// never enter it. In upward rounding.
void find_first_hits(std::span<const TraceFrame> surfaces, std::span<const SceneRay> rays,
                     std::span<RayHit> hits, Counters& counters);

/// For each ray whether any root lies on it, 1 or 0; 1 too where that is not decided on a stretch
/// on which f is continuous.
void find_blocked(std::span<const TraceFrame> surfaces, std::span<const SceneRay> rays,
                  std::span<std::uint8_t> blocked, Counters& counters);

}  // namespace zeroset
