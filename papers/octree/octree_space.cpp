#include "papers/octree/octree_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// The least k with 2^k >= value > 0.
int exponent_above(double value) {
    const int exponent = std::ilogb(value);
    return std::ldexp(1.0, exponent) < value ? exponent + 1 : exponent;
}

/// The level whose octants are no larger than a cell of the search.
int wanted_level(const TraceFrame& frame, const OctreeSpace& space) {
    const double size = frame.scene.clip.size();
    if (frame.stop.rule == StopRule::Epsilon) {
        // An octant's diagonal is sqrt(3) times its edge.
        return std::max(1, exponent_above(space.edge * std::sqrt(3.0) / frame.stop.value));
    }
    return frame.depth.wanted + exponent_above(space.edge / size);
}

}  // namespace

OctreeSpace octree_space(const Box& clip) {
    for (int exponent = exponent_above(clip.size());; ++exponent) {
        const double edge = std::ldexp(1.0, exponent);
        const double voxel = std::ldexp(edge, -voxel_level);
        const glm::dvec3 corner = voxel * glm::floor(clip.lo / voxel);
        if (!glm::all(glm::lessThanEqual(clip.hi, corner + edge))) continue;
        const glm::dvec3 far = glm::max(glm::abs(corner), glm::abs(corner + edge));
        const int reach = exponent_above(std::max({far.x, far.y, far.z}));
        const int finest = exponent - reach + std::numeric_limits<double>::digits;
        return {.corner = corner, .edge = edge, .finest = std::clamp(finest, 1, max_levels)};
    }
}

LeafLevel leaf_level(const TraceFrame& frame, const OctreeSpace& space) {
    int finest = space.finest;
    if (frame.precision == Precision::Float) {
        const Box& clip = frame.scene.clip;
        const glm::dvec3 far = glm::max(glm::abs(clip.lo), glm::abs(clip.hi));
        const int halvings = deepest_halving(clip, std::max({far.x, far.y, far.z}),
                                             std::numeric_limits<float>::digits);
        finest = std::min(finest, halvings + exponent_above(space.edge / clip.size()));
    }
    const int wanted = wanted_level(frame, space);
    const int level = std::clamp(wanted, 1, finest);
    return {.level = level, .missed = std::max(wanted - level, 0)};
}

}  // namespace zeroset
