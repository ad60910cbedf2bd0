#pragma once

#include "engine/trace/trace_frame.hpp"
#include "engine/view/box.hpp"

#include <glm/glm.hpp>

namespace zeroset {

/// The level to which space is voxelised before a frame [Stolte05, sec. 3].
inline constexpr int voxel_level = 9;
/// The most levels that may be asked for: the bits of a double [Stolte05, sec. 2.2].
inline constexpr int max_levels = 53;

/// The cube that an octree divides: around the clip box, with a power of two for an edge and its
/// corner on the grid of the voxels, so that the faces of all octants down to `finest` are numbers
/// in double, without rounding.
struct OctreeSpace {
    glm::dvec3 corner;  ///< the one with the least coordinates
    double edge;
    int finest;  ///< at most max_levels; at least 1
};

OctreeSpace octree_space(const Box& clip);

/// NL, the level of the leaves: octants no larger than the cells that the frame is searched to, or
/// than the frame's numbers tell apart.
struct LeafLevel {
    int level;   ///< NL
    int missed;  ///< levels that are wanted beyond

    /// Whether leaves are fine enough for certificates.
    [[nodiscard]] bool certifies() const { return missed <= most_missed_halvings; }
};
LeafLevel leaf_level(const TraceFrame& frame, const OctreeSpace& space);

}  // namespace zeroset
