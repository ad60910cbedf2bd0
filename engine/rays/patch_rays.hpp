#pragma once

#include "engine/rays/scene_ray.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstdint>
#include <span>

namespace zeroset {

/// Takes the hits of a parametric surface (PatchCode) that are nearer than those so far; all
/// rays are clipped. In upward rounding.
void find_on_patch(const TraceFrame& surface, std::uint8_t number, std::span<const SceneRay> rays,
                   std::span<RayHit> hits, Counters& counters);

/// Marks those of the rays that are not blocked yet on which a place of a parametric surface lies,
/// or may; all rays are clipped. In upward rounding.
void block_by_patch(const TraceFrame& surface, std::uint8_t number, std::span<const SceneRay> rays,
                    std::span<std::uint8_t> blocked, Counters& counters);

}  // namespace zeroset
