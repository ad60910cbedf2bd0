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

/// Whether a place of a parametric surface lies on the ray, or may.
bool is_blocked_by_patch(const TraceFrame& surface, std::uint8_t number, const SceneRay& ray,
                         Counters& counters);

}  // namespace zeroset
