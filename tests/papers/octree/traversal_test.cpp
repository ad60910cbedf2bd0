#include "engine/real/rounding.hpp"
#include "papers/octree/octree_memory.hpp"
#include "papers/octree/ray_voxelisation.hpp"
#include "papers/octree/verification.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// How rays pass octants: against numbers of 128 bits, and on rays along planes and axes.

namespace zeroset::test::traversal_test {
namespace {

constexpr Traversal all_traversals[] = {Traversal::Octree, Traversal::Unrounded,
                                        Traversal::Gargantini};

TraversalCheck checked(const std::string& text, const Camera& camera, Traversal traversal,
                       double levels) {
    const Scene scene = scene_of(text, Box::cube(2));
    const ViewFrame view(camera);
    TraceFrame frame = trace_frame(scene, scene.surfaces.front(), view, {.width = 40, .height = 40},
                                   {StopRule::DStop, levels});
    frame.precision = Precision::Double;
    const auto octree = prepare_octree(frame, 2);
    frame.prepared = octree.get();
    return verify_traversal(frame, traversal, 2);
}

const std::string texts[] = {"x^2 + y^2 + z^2 = 1", "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8"};

Camera parallel(Camera camera) {
    camera.projection = Projection::Orthographic;
    return camera;
}

std::vector<Camera> cameras() {
    const Camera usual = default_camera(Box::cube(2));
    Camera inside = usual;
    inside.eye = {0.1, 0.2, -0.3};
    inside.look_at = {1.3, 0.4, 0.2};
    return {usual, parallel(usual), inside};
}

TEST(Traversal, OfTheOctreeMissesNothingAtAnyLevel) {
    const std::vector all_levels =
        is_long_run() ? std::vector{10.0, 20.0, 30.0, 40.0, 50.0, 53.0} : std::vector{10.0, 53.0};
    for (const std::string& text : texts) {
        for (const Camera& camera : cameras()) {
            for (const double levels : all_levels) {
                SCOPED_TRACE(text + ", levels " + std::to_string(levels));
                const TraversalCheck check = checked(text, camera, Traversal::Octree, levels);
                EXPECT_GT(check.octants, 1500U);
                EXPECT_GT(check.rays, 150U);
                EXPECT_EQ(check.missed, 0U);
                EXPECT_LE(check.differing, check.extra);
                // Octants that the ray only comes near are told apart where it starts before the
                // cube.
                if (camera.eye != cameras().back().eye) {
                    EXPECT_EQ(check.extra, 0U);
                }
            }
        }
    }
}

TEST(Traversal, AllAreTheSameFarFromTheLimitOfDouble) {
    for (const std::string& text : texts) {
        for (const Traversal traversal : all_traversals) {
            const TraversalCheck check = checked(text, cameras().front(), traversal, 20);
            EXPECT_EQ(check.differing, 0U) << name_of(traversal);
        }
    }
}

TEST(Traversal, OthersMissOctantsNearTheLimitOfDouble) {
    for (const Traversal traversal : {Traversal::Unrounded, Traversal::Gargantini}) {
        std::uint64_t missed = 0;
        for (const std::string& text : texts)
            missed += checked(text, cameras().front(), traversal, 53).missed;
        EXPECT_GT(missed, 0U) << name_of(traversal);
    }
}

template <class Method>
SubOctants passed_by(const OctreeRay& ray, const Octant& octant) {
    SubOctants passed;
    Method::pass(ray, octant, passed);
    return passed;
}

TEST(Traversal, AllAreFrontToBack) {
    RandomNumbers random(7);
    const UpwardRounding upward;
    for (int turn = 0; turn < 2000; ++turn) {
        OctreeRay ray{};
        for (int axis = 0; axis < 3; ++axis) {
            ray.start[axis] = random.uniform(-1.5, 1.0);
            ray.c[axis] = random.uniform(0.01, 1.0);
        }
        ray.to = 1e3;
        const Octant cube{.corner = glm::dvec3(-1), .length = 2.0, .in = 0.0, .out = 1e3};
        const SubOctants exact = passed_by<RoundedVoxelisation>(ray, cube);
        for (std::size_t i = 1; i < exact.count; ++i) {
            EXPECT_NEAR(exact.in[i], exact.out[i - 1], 1e-12);
            // Each lies behind the one before along some axes, and before it along none.
            EXPECT_EQ(exact.index[i] & exact.index[i - 1], exact.index[i - 1]);
        }
        const SubOctants unrounded = passed_by<UnroundedVoxelisation>(ray, cube);
        ASSERT_EQ(unrounded.count, exact.count);
        EXPECT_TRUE(std::equal(exact.index.begin(), exact.index.begin() + exact.count,
                               unrounded.index.begin()));
        if (exact.count == 0) continue;
        // Gargantini's begins with where the ray enters and leaves.
        Octant entered = cube;
        entered.in = exact.in[0];
        entered.out = exact.out[exact.count - 1];
        const SubOctants gargantini = passed_by<GargantiniTraversal>(ray, entered);
        ASSERT_EQ(gargantini.count, exact.count);
        EXPECT_TRUE(std::equal(exact.index.begin(), exact.index.begin() + exact.count,
                               gargantini.index.begin()));
    }
}

}  // namespace
}  // namespace zeroset::test::traversal_test
