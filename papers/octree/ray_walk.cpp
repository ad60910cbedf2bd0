// The traversal [Stolte05, fig. 1]: down the octree in memory by its bits, beyond it by asking the
// kernel for each octant that the ray passes.

#include "papers/octree/ray_walk.hpp"

#include <cmath>

namespace zeroset {

bool WalkPlan::is_leaf(const OctreeRay& ray, int level, double in) const {
    if (level >= leaf_level) return true;
    if (level < leaf_level - coarser || coarser == 0) return false;
    // A leaf at the eye is 2^-leaf_level of the edge, one that far away as wide as that is far,
    // times 2^-(leaf_level - coarser).
    const double distance = std::abs(ray.point(in)[ray.k] - eye[ray.k]);
    return std::ldexp(space.edge, -level) <= std::ldexp(distance, coarser - leaf_level);
}

/// Leaves of the octants passed those that the octree has.
void RayWalk::keep_voxelised(const Octree::Node& node) {
    SubOctants& passed = levels_[depth_].passed;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < passed.count; ++i) {
        const unsigned octant = passed.index[i] ^ ray_.sign_dir;
        if ((node.octants >> octant & 1U) == 0) continue;
        passed.move(i, kept++);
    }
    passed.count = kept;
}

}  // namespace zeroset
