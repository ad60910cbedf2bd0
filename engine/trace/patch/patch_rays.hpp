#pragma once

#include "engine/trace/patch/patch_search.hpp"
#include "engine/trace/trace_frame.hpp"

#include <glm/glm.hpp>

namespace zeroset {

/// A ray from anywhere: the points origin + t direction, t from `from` to `to`. The direction has
/// length 1.
struct PatchRay {
    glm::dvec3 origin, direction;
    double from, to;
};

/// The first hit of a parametric surface (PatchCode) on a ray; PatchHit::s is t. `any`: one
/// that need not be the first will do. In upward rounding.
PatchHit find_patch_hit(const TraceFrame& frame, const PatchRay& ray, bool any, Counters& counters);

/// The first hit of a patch on a ray, without a frame; `tolerance`: a bracket's width that is
/// narrow enough.
PatchHit find_patch_hit(const PatchTree& tree, const PatchRay& ray, double tolerance);

/// How far from a place of the patch a ray begins that leaves it, so that it does not meet it
/// there: as far as that of shadows.
double patch_bias(const TraceFrame& frame);

}  // namespace zeroset
