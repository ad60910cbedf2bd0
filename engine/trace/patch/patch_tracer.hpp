#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstdint>
#include <span>

namespace zeroset {

/// The first hits of a parametric surface (PatchCode) in a tile, as Tracer::trace_tile; the
/// frame's `prepared` is a PatchTree. Gradients are dS/du x dS/dv.
void trace_tile_patch(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters);

/// Whether a parametric surface is on a ray.
enum class PatchBlock : std::uint8_t { None, Proved, Unknown };

/// Looks for places of a parametric surface on rays of a view: at (u, v) of the image plane, as
/// TileRays has them, before the depths `to`; -inf: the ray is not wanted. One item for each pixel
/// of a tile.
void find_patch_blocks(const TraceFrame& frame, const TileRays& rays, std::span<const double> u,
                       std::span<const double> v, std::span<const double> to,
                       std::span<PatchBlock> blocks, Counters& counters);

}  // namespace zeroset
