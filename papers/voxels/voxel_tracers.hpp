#pragma once

#include "engine/trace/ray_lines.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"
#include "papers/along_rays/hit_writer.hpp"
#include "papers/voxels/voxel_ray.hpp"
#include "papers/voxels/voxel_walk.hpp"

#include <cstdint>
#include <span>

namespace zeroset {

/// The ways to intersect a ray with a voxel; each is told of in the file of its name.
enum class VoxelMethod : std::uint8_t { Midpoint, Linear, Neubauer, Schwarze, Marmitt };
/// One ray after another, or as many at once as the machine's vectors have lanes.
enum class RaysAtOnce : std::uint8_t { One, Packet };

/// The first hits in a tile by a method, in packets.
void trace_tile_by(VoxelMethod method, const TraceFrame& frame, const Tile& tile, TileHits& hits,
                   Counters& counters);
/// Tracer::trace_tile of a method.
template <VoxelMethod method>
void trace_tile_voxels(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters) {
    trace_tile_by(method, frame, tile, hits, counters);
}

/// The first hits in voxels that are padded; +inf: none. `t`: as long as their columns.
void find_first_hits(VoxelMethod method, RaysAtOnce rays, const VoxelRays& voxels,
                     std::span<float> t);

/// The values that a method works with in a tile.
struct VoxelTask {
    const TraceFrame& frame;
    const RayLines& lines;
    const VoxelWalk& walk;
    HitWriter& writer;
    Counters& counters;
};

}  // namespace zeroset
