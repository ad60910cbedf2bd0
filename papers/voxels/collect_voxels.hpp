#pragma once

#include "engine/trace/trace_frame.hpp"
#include "papers/voxels/voxel_ray.hpp"

#include <cstddef>
#include <vector>

namespace zeroset {

/// The voxels that an exact method looks at in a frame: those of each ray that hold the level, up
/// to its first proved root; each list of `at_once`, but for the last one, padded. Nothing where
/// the surface is no plain isosurface. In upward rounding.
std::vector<VoxelRays> collect_voxels(const TraceFrame& frame, std::size_t at_once);

}  // namespace zeroset
