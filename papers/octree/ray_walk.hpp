#pragma once

#include "engine/trace/tile_hits.hpp"
#include "papers/octree/octree.hpp"
#include "papers/octree/octree_ray.hpp"
#include "papers/octree/octree_space.hpp"
#include "papers/octree/ray_voxelisation.hpp"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// The values that a frame's walks have in common.
struct WalkPlan {
    const Octree* octree;  ///< of this space
    OctreeSpace space;
    int leaf_level;  ///< NL
    /// Levels by which leaves may be larger far from the eye (SearchDepth::deeper).
    int coarser = 0;
    glm::dvec3 eye{0.0};

    /// Whether an octant of this level, which the ray enters at T = in, is a leaf.
    [[nodiscard]] bool is_leaf(const OctreeRay& ray, int level, double in) const;
};

/// A ray's way through the octants, recursive in the paper [Stolte05, fig. 1], here with a stack of
/// its own, so that many rays wait for one batch of the kernel.
class RayWalk {
public:
    enum class State : std::uint8_t {
        Ended,   ///< there are no more octants
        Asks,    ///< it waits to hear which of `asked` may hold the surface
        AtLeaf,  ///< `leaf` may hold it
    };

    /// The ray must have been found.
    template <class Method>
    State begin(const WalkPlan& plan, const OctreeRay& ray, TileHits::Pixel pixel);
    /// Goes on to the next octant that may hold the surface.
    template <class Method>
    State go_on(const WalkPlan& plan);

    /// Octants that the ray passes, in order; the kernel is to judge them.
    [[nodiscard]] const SubOctants& asked() const { return levels_[depth_].passed; }
    [[nodiscard]] Octant asked_octant(std::size_t i) const { return octant(depth_, i); }
    /// Leaves of them those of which `keep(i)` says more than Drop: that octant i may hold the
    /// surface, or that it is even a leaf.
    enum class Keep : std::uint8_t { Drop, Divide, Stop };
    template <class Judge>
    void keep_asked(const Judge& keep) {
        Level& level = levels_[depth_];
        std::size_t kept = 0;
        for (std::size_t i = 0; i < level.passed.count; ++i) {
            const Keep judged = keep(i);
            if (judged == Keep::Drop) continue;
            if (judged == Keep::Stop) level.stops |= static_cast<std::uint8_t>(1U << kept);
            level.passed.move(i, kept++);
        }
        level.passed.count = kept;
    }

    [[nodiscard]] const OctreeRay& ray() const { return ray_; }
    [[nodiscard]] TileHits::Pixel pixel() const { return pixel_; }
    [[nodiscard]] const Octant& leaf() const { return leaf_; }

    int refused_leaves = 0;
    bool unsettled = false;  ///< a leaf could be neither refused nor taken for a hit

private:
    struct Level {
        glm::dvec3 corner;
        double length;
        SubOctants passed;
        std::size_t next;    ///< of `passed`
        std::uint32_t node;  ///< of the octree; no_node: below the voxels
        std::uint8_t stops;  ///< bits of those of `passed` that are leaves
    };

    [[nodiscard]] Octant octant(std::size_t depth, std::size_t i) const {
        const Level& level = levels_[depth];
        return sub_octant(level.corner, level.length, level.passed.index[i], level.passed.in[i],
                          level.passed.out[i]);
    }
    template <class Method>
    void enter(const Octant& octant, std::uint32_t node);
    void keep_voxelised(const Octree::Node& node);

    OctreeRay ray_{};
    TileHits::Pixel pixel_{};
    std::size_t depth_ = 0;
    Octant leaf_{};
    std::array<Level, max_levels> levels_;
};

template <class Method>
void RayWalk::enter(const Octant& octant, std::uint32_t node) {
    Level& level = levels_[depth_];
    level.corner = octant.corner;
    level.length = octant.length;
    Method::pass(ray_, octant, level.passed);
    level.next = 0;
    level.node = node;
    level.stops = 0;
}

template <class Method>
RayWalk::State RayWalk::begin(const WalkPlan& plan, const OctreeRay& ray, TileHits::Pixel pixel) {
    ray_ = ray;
    pixel_ = pixel;
    depth_ = 0;
    refused_leaves = 0;
    unsettled = false;
    const bool voxelised = plan.octree != nullptr && plan.octree->depth() > 0;
    enter<Method>(ray.root(plan.space), voxelised ? 0 : Octree::no_node);
    if (!voxelised) return State::Asks;
    keep_voxelised(plan.octree->node(0, 0));
    return go_on<Method>(plan);
}

template <class Method>
RayWalk::State RayWalk::go_on(const WalkPlan& plan) {
    for (;;) {
        Level& level = levels_[depth_];
        if (level.next == level.passed.count) {
            if (depth_ == 0) return State::Ended;
            --depth_;
            continue;
        }
        const std::size_t i = level.next++;
        if (level.passed.in[i] > ray_.limit) return State::Ended;
        const Octant next = octant(depth_, i);
        const int own_level = static_cast<int>(depth_) + 1;
        const bool in_octree = level.node != Octree::no_node;
        if ((level.stops >> i & 1U) != 0 || plan.is_leaf(ray_, own_level, next.in)) {
            leaf_ = next;
            return State::AtLeaf;
        }
        std::uint32_t node = Octree::no_node;
        if (in_octree && own_level < plan.octree->depth())
            node = Octree::place_of(plan.octree->node(own_level - 1, level.node),
                                    level.passed.index[i] ^ ray_.sign_dir);
        ++depth_;
        assert(depth_ < levels_.size());
        enter<Method>(next, node);
        if (node == Octree::no_node) return State::Asks;
        keep_voxelised(plan.octree->node(own_level, node));
    }
}

}  // namespace zeroset
