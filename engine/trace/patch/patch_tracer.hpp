#pragma once

#include "engine/trace/followed_rays.hpp"
#include "engine/trace/patch/patch_search.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <glm/glm.hpp>

#include <span>

namespace zeroset {

/// The first hits of a parametric surface (PatchCode) in a tile, as Tracer::trace_tile; the
/// frame's `prepared` is a PatchTree. Gradients are dS/du x dS/dv.
void trace_tile_patch(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters);

/// Looks for places of a parametric surface on the rays of a tile's blocks, which are those of the
/// frame's view.
void follow_patch(const TraceFrame& frame, const TileRays& rays, std::span<FollowedRays> blocks,
                  Counters& counters);

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
