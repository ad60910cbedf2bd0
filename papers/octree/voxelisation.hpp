#pragma once

#include "engine/trace/trace_frame.hpp"
#include "papers/octree/octree.hpp"

#include <memory>

namespace zeroset {

/// Voxelises a surface down to a level, on so many threads (0: all cores): an octant stays where
/// the enclosure of f in its part of the clip box does not exclude 0. Fewer levels where the
/// frame's limit is over before. The frame's kernel is that of the whole surface.
std::shared_ptr<const Octree> voxelise(const TraceFrame& frame, int level, int threads);

}  // namespace zeroset
