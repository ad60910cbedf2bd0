#include "engine/real/rounding.hpp"
#include "papers/octree/octree_memory.hpp"
#include "papers/octree/octree_space.hpp"
#include "papers/octree/voxelisation.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

// The cube that is divided, the static voxelisation, and how long octrees are kept.

namespace zeroset::test::octree_test {
namespace {

/// A scene and a frame of it.
struct Framed {
    Scene scene;
    Camera camera;
    ViewFrame view;
    TraceFrame frame;

    explicit Framed(const std::string& text, const Box& clip = Box::cube(2),
                    const StopCriterion& stop = {}, int size = 512)
        : scene(scene_of(text, clip)),
          camera(default_camera(clip)),
          view(camera),
          frame(trace_frame(scene, scene.surfaces.front(), view, {.width = size, .height = size},
                            stop)) {}
    Framed(const Framed&) = delete;
    Framed& operator=(const Framed&) = delete;
};

TEST(OctreeSpace, HoldsTheClipBoxOnExactPlanes) {
    for (const Box& clip : {Box::cube(2), Box{.lo = glm::dvec3(0), .hi = glm::dvec3(1)},
                            Box::cube(1.3), Box{.lo = {0.1, -7, 3}, .hi = {0.2, -6.99, 3.3}},
                            Box{.lo = glm::dvec3(1e6), .hi = glm::dvec3(1e6 + 0.7)},
                            Box{.lo = glm::dvec3(0.7), .hi = glm::dvec3(0.7 + 0x1p-50)}}) {
        const OctreeSpace space = octree_space(clip);
        SCOPED_TRACE(clip.lo.x);
        EXPECT_LE(space.edge, 4 * clip.size());
        EXPECT_GE(space.finest, 1);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(space.corner[axis], clip.lo[axis]);
            EXPECT_GE(space.corner[axis] + space.edge, clip.hi[axis]);
            // The first plane and the last but one of the deepest level.
            const double leaf = std::ldexp(space.edge, -space.finest);
            EXPECT_EQ((space.corner[axis] + leaf) - space.corner[axis], leaf);
            const double end = space.corner[axis] + space.edge;
            EXPECT_EQ(end - (end - leaf), leaf);
        }
    }
    EXPECT_EQ(octree_space(Box::cube(2)).finest, max_levels);
    EXPECT_EQ(octree_space({.lo = glm::dvec3(0), .hi = glm::dvec3(1)}).finest, max_levels);
}

TEST(OctreeSpace, LeavesAreAsFineAsCells) {
    for (const double half : {1.0, 1.3, 2.0, 3.0}) {
        for (const double d_stop : {8.0, 14.0, 19.0}) {
            const Framed framed("x", Box::cube(half), {StopRule::DStop, d_stop});
            const OctreeSpace space = octree_space(framed.scene.clip);
            const double leaf = std::ldexp(space.edge, -leaf_level(framed.frame, space).level);
            EXPECT_LE(leaf, 2 * half * std::exp2(-d_stop));
            EXPECT_GT(leaf, half * std::exp2(-d_stop));
            EXPECT_TRUE(leaf_level(framed.frame, space).certifies());
        }
    }
}

/// The octree's octants of a level, as boxes.
void list_voxels(const Octree& octree, int level, std::uint32_t place, const Box& box,
                 std::vector<Box>& voxels) {
    if (level == octree.depth()) {
        voxels.push_back(box);
        return;
    }
    const Octree::Node& node = octree.node(level, place);
    const glm::dvec3 middle = box.centre();
    for (unsigned octant = 0; octant < 8; ++octant) {
        if ((node.octants >> octant & 1U) == 0) continue;
        Box part = box;
        for (int axis = 0; axis < 3; ++axis)
            ((octant >> axis & 1U) != 0 ? part.lo : part.hi)[axis] = middle[axis];
        const bool last = level + 1 == octree.depth();
        list_voxels(octree, level + 1, last ? 0 : Octree::place_of(node, octant), part, voxels);
    }
}

std::vector<Box> voxels_of(const Octree& octree) {
    std::vector<Box> voxels;
    list_voxels(octree, 0, 0, {octree.space.corner, octree.space.corner + octree.space.edge},
                voxels);
    return voxels;
}

TEST(Voxelisation, IsThatOfABall) {
    for (const StopCriterion stop : {StopCriterion{StopRule::DStop, 12}}) {
        const Framed framed("x^2 + y^2 + z^2 = 1", Box::cube(2), stop);
        const auto octree = voxelise(framed.frame, 6, 2);
        ASSERT_EQ(octree->depth(), 6);
        const std::vector<Box> voxels = voxels_of(*octree);
        EXPECT_EQ(octree->voxels(), voxels.size());
        // Just those voxels that hold points on both sides, or touch the sphere.
        std::size_t touched = 0;
        const double length = 4.0 / 64;
        for (int i = 0; i < 64 * 64 * 64; ++i) {
            const glm::dvec3 lo = -2.0 + length * glm::dvec3(i % 64, i / 64 % 64, i / 4096);
            const glm::dvec3 hi = lo + length;
            const glm::dvec3 far = glm::max(glm::abs(lo), glm::abs(hi));
            const glm::dvec3 near = glm::clamp(glm::dvec3(0), lo, hi);
            if (glm::dot(near, near) <= 1 && glm::dot(far, far) >= 1) ++touched;
        }
        EXPECT_EQ(voxels.size(), touched);
        for (const Box& voxel : voxels)
            EXPECT_NEAR(glm::length(voxel.centre()), 1.0, 0.87 * length);
    }
}

TEST(Voxelisation, IsTheSameOnAnyThreadsAndInDouble) {
    Framed framed("sin(3x) sin(4y) = z", Box::cube(1.7));
    const auto one = voxelise(framed.frame, 7, 1);
    const auto two = voxelise(framed.frame, 7, 2);
    ASSERT_EQ(one->depth(), two->depth());
    for (std::size_t level = 0; level < one->levels.size(); ++level) {
        ASSERT_EQ(one->levels[level].size(), two->levels[level].size());
        for (std::size_t i = 0; i < one->levels[level].size(); ++i) {
            ASSERT_EQ(one->levels[level][i].octants, two->levels[level][i].octants);
            ASSERT_EQ(one->levels[level][i].first, two->levels[level][i].first);
        }
    }
    framed.frame.precision = Precision::Double;
    const std::size_t in_double = voxelise(framed.frame, 7, 2)->voxels();
    EXPECT_LE(in_double, one->voxels());
    EXPECT_GT(in_double, one->voxels() * 9 / 10);
}

TEST(Voxelisation, KeepsNothingOutsideOfTheClipBox) {
    // The cube has an edge of 4, the clip box is a plate in it.
    const Box clip{.lo = {-1.5, -1.5, -0.1}, .hi = {1.5, 1.5, 0.1}};
    const Framed framed("x = 0", clip);
    for (const Box& voxel : voxels_of(*voxelise(framed.frame, 6, 2))) {
        EXPECT_LT(voxel.lo.z, 0.1);
        EXPECT_GT(voxel.hi.z, -0.1);
        EXPECT_LE(voxel.lo.x, 0.0);
        EXPECT_GE(voxel.hi.x, 0.0);
    }
}

TEST(Voxelisation, EndsWithItsLimit) {
    Framed framed("x^2 + y^2 + z^2 = 1");
    const std::atomic<bool> cancel{true};
    framed.frame.limit.cancel = &cancel;
    EXPECT_EQ(voxelise(framed.frame, 6, 2)->depth(), 0);
    EXPECT_EQ(prepare_octree(framed.frame, 2), nullptr);
}

const void* prepared_of(const TraceFrame& frame) { return prepare_octree(frame, 2).get(); }

TEST(OctreeMemory, KeepsAnOctreeUntilTheSurfaceChanges) {
    Framed framed("x^2 + y^2 + z^2 = 1", Box::cube(2), {}, 60);
    const auto octree = std::static_pointer_cast<const Octree>(prepare_octree(framed.frame, 2));
    EXPECT_EQ(octree->depth(), 6);
    EXPECT_EQ(prepared_of(framed.frame), octree.get());
    // Another view, another kernel object of the same code.
    const Surface copy = framed.scene.surfaces.front();
    Camera moved = framed.camera;
    moved.eye.x += 1.0;
    const ViewFrame view(moved);
    const TraceFrame other = trace_frame(framed.scene, copy, view, {.width = 60, .height = 40}, {});
    EXPECT_EQ(prepared_of(other), octree.get());
    // A smaller picture can do with it, a larger one cannot.
    framed.frame.image = {.width = 20, .height = 20};
    EXPECT_EQ(prepared_of(framed.frame), octree.get());
    framed.frame.image = {.width = 100, .height = 100};
    EXPECT_NE(prepared_of(framed.frame), octree.get());
    framed.frame.image = {.width = 60, .height = 60};
    // Parameters, the box, the precision.
    framed.scene.uniforms.set(0, 0.5);
    EXPECT_NE(prepared_of(framed.frame), octree.get());
    framed.scene.uniforms.set(0, 0.0);
    EXPECT_EQ(prepared_of(framed.frame), octree.get());
    framed.scene.clip = Box::cube(1.9);
    EXPECT_NE(prepared_of(framed.frame), octree.get());
    framed.scene.clip = Box::cube(2);
    framed.frame.precision = Precision::Double;
    EXPECT_NE(prepared_of(framed.frame), octree.get());
}

TEST(OctreeMemory, GoesWithTheKernel) {
    std::weak_ptr<const PreparedSurface> kept;
    {
        const Framed framed("x^2 + y^2 + z^2 = 1", Box::cube(2), {}, 60);
        kept = prepare_octree(framed.frame, 2);
        EXPECT_FALSE(kept.expired());
    }
    EXPECT_TRUE(kept.expired());
}

}  // namespace
}  // namespace zeroset::test::octree_test
