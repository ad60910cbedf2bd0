// The tracers of plain isosurfaces by the methods that [Marmitt04] compares.

#include "papers/voxels/voxel_tracers.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "papers/voxels/voxel_tracers.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "papers/voxels/linear-inl.hpp"
#include "papers/voxels/marmitt-inl.hpp"
#include "papers/voxels/midpoint-inl.hpp"
#include "papers/voxels/neubauer-inl.hpp"
#include "papers/voxels/schwarze-inl.hpp"
#include "papers/voxels/voxel_loops-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Run>
void with_method(VoxelMethod method, const Run& run) {
    switch (method) {
        case VoxelMethod::Midpoint: return run(Midpoint());
        case VoxelMethod::Linear: return run(Linear());
        case VoxelMethod::Neubauer: return run(Neubauer());
        case VoxelMethod::Schwarze: return run(Schwarze());
        case VoxelMethod::Marmitt: return run(Marmitt());
    }
}

void trace_voxels(VoxelMethod method, const VoxelTask& tile) {
    with_method(method, [&](auto of) { VoxelTracer<decltype(of)>(tile).run(); });
}

void find_hits(VoxelMethod method, RaysAtOnce rays, const VoxelRays& voxels, float* t) {
    with_method(method, [&](auto of) {
        if (rays == RaysAtOnce::One)
            return find_hits_of<hn::CappedTag<float, 1>, decltype(of)>(voxels, t);
        find_hits_of<Tag<float>, decltype(of)>(voxels, t);
    });
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "engine/real/rounding.hpp"
#include "engine/trace/voxels/isosurface.hpp"

#include <limits>

namespace zeroset {
namespace {

HWY_EXPORT(trace_voxels);
HWY_EXPORT(find_hits);

}  // namespace

void trace_tile_by(VoxelMethod method, const TraceFrame& frame, const Tile& tile, TileHits& hits,
                   Counters& counters) {
    const auto surface = isosurface(frame.kernel, frame.scene);
    if (!surface) return hits.leave_undecided(tile);
    thread_local RayLines lines;
    const TileRays rays(frame, tile);
    lines.begin(frame, tile, rays, std::numeric_limits<float>::digits);
    if (lines.pixels().empty()) return;
    const NearestCall nearest;
    const auto walk = VoxelWalk::make(*surface);
    HitWriter writer(rays, lines, hits);
    HWY_DYNAMIC_DISPATCH(trace_voxels)
    (method,
     {.frame = frame, .lines = lines, .walk = *walk, .writer = writer, .counters = counters});
}

void find_first_hits(VoxelMethod method, RaysAtOnce rays, const VoxelRays& voxels,
                     std::span<float> t) {
    HWY_DYNAMIC_DISPATCH(find_hits)(method, rays, voxels, t.data());
}

}  // namespace zeroset

#endif
