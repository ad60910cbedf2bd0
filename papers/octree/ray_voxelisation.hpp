#pragma once

#include "papers/octree/octant.hpp"
#include "papers/octree/octree_ray.hpp"

// The ways of a ray through an octant: which of its sub-octants it passes, in order; `passed` gets
// them, whatever it held.

namespace zeroset {

/// The ray voxelised by its implicit form [Stolte05, eq. 4 and sec. 2.4], with bounds that are
/// rounded outward, and exactly where these leave it open: just the sub-octants with more than a
/// point of the ray, in BSP order, if it starts on the grid; else at least those. In upward
/// rounding.
struct RoundedVoxelisation {
    static constexpr bool proves = true;
    static void pass(const OctreeRay& ray, const Octant& octant, SubOctants& passed);
};

/// The ray voxelised by its implicit form, regardless of rounding: each plane's number is both
/// bounds.
struct UnroundedVoxelisation {
    static constexpr bool proves = false;
    static void pass(const OctreeRay& ray, const Octant& octant, SubOctants& passed);
};

/// Intersections with the mid-planes, sorted [Gargantini93], as in [Stolte05, sec. 2.6].
struct GargantiniTraversal {
    static constexpr bool proves = false;
    static void pass(const OctreeRay& ray, const Octant& octant, SubOctants& passed);
};

}  // namespace zeroset
