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

/// Calls `run(tag, method)` with one ray a vector, or with full vectors.
template <class Run>
void with_method(VoxelMethod method, RaysAtOnce rays, const Run& run) {
    const auto in_lanes = [&](auto of) {
        if (rays == RaysAtOnce::One) return run(hn::CappedTag<float, 1>(), of);
        return run(Tag<float>(), of);
    };
    switch (method) {
        case VoxelMethod::Midpoint: return in_lanes(Midpoint());
        case VoxelMethod::Linear: return in_lanes(Linear());
        case VoxelMethod::Neubauer: return in_lanes(Neubauer());
        case VoxelMethod::Schwarze: return in_lanes(Schwarze());
        case VoxelMethod::Marmitt: return in_lanes(Marmitt());
    }
}

void trace_voxels(VoxelMethod method, RaysAtOnce rays, const VoxelTask& tile) {
    with_method(method, rays,
                [&](auto tag, auto of) { VoxelTracer<decltype(tag), decltype(of)>(tile).run(); });
}

void find_hits(VoxelMethod method, RaysAtOnce rays, const VoxelRays& voxels, float* t) {
    with_method(method, rays,
                [&](auto tag, auto of) { find_hits_of<decltype(tag), decltype(of)>(voxels, t); });
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

void trace_tile(VoxelMethod method, RaysAtOnce rays_at_once, const TraceFrame& frame,
                const Tile& tile, TileHits& hits, Counters& counters) {
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
    (method, rays_at_once,
     {.frame = frame, .lines = lines, .walk = *walk, .writer = writer, .counters = counters});
}

}  // namespace

template <VoxelMethod method, RaysAtOnce rays>
void trace_tile_voxels(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters) {
    trace_tile(method, rays, frame, tile, hits, counters);
}

#define ZEROSET_VOXEL_TRACER(method)                                          \
    template void trace_tile_voxels<VoxelMethod::method, RaysAtOnce::One>(    \
        const TraceFrame&, const Tile&, TileHits&, Counters&);                \
    template void trace_tile_voxels<VoxelMethod::method, RaysAtOnce::Packet>( \
        const TraceFrame&, const Tile&, TileHits&, Counters&);
ZEROSET_VOXEL_TRACER(Midpoint)
ZEROSET_VOXEL_TRACER(Linear)
ZEROSET_VOXEL_TRACER(Neubauer)
ZEROSET_VOXEL_TRACER(Schwarze)
ZEROSET_VOXEL_TRACER(Marmitt)
#undef ZEROSET_VOXEL_TRACER

void find_first_hits(VoxelMethod method, RaysAtOnce rays, const VoxelRays& voxels,
                     std::span<float> t) {
    HWY_DYNAMIC_DISPATCH(find_hits)(method, rays, voxels, t.data());
}

}  // namespace zeroset

#endif
