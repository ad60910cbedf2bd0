#include "engine/trace/ways/surface_ways.hpp"

#include "engine/trace/blobs/blob_way.hpp"
#include "engine/trace/patch/patch_way.hpp"
#include "engine/trace/voxels/voxel_way.hpp"
#include "tests/support/blob_scenes.hpp"
#include "tests/support/patch_scenes.hpp"
#include "tests/support/rays.hpp"
#include "tests/support/voxel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <typeinfo>

namespace zeroset::test::surface_ways_test {
namespace {

const std::type_info& kind_of(const Scene& scene) {
    const SurfaceWay& way = way_of(scene.surfaces.front().kernel);
    return typeid(way);
}

Scene patch() { return patch_scene({"x", "y", "x y"}, Way::WithoutModels, Box::cube(2)); }

TEST(SurfaceWays, AreThoseOfTheKinds) {
    const Both balls = both_of(BlobKind::Wyvill, {}, 1);
    const auto volume =
        volume_from({3, 3, 3}, {}, [](double i, double j, double k) { return i + j * k; });
    EXPECT_EQ(kind_of(scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2))), typeid(SurfaceWay));
    EXPECT_EQ(kind_of(balls.balls), typeid(BlobWay));
    EXPECT_EQ(kind_of(balls.beams), typeid(SurfaceWay)) << "nothing is known of its function";
    EXPECT_EQ(kind_of(scene_of_level(volume, 1)), typeid(VoxelWay));
    EXPECT_EQ(kind_of(patch()), typeid(PatchWay));
}

TEST(SurfaceWays, FindTheSameOnARayAsFirstHits) {
    const Scene scene = patch();
    const Kernel& kernel = scene.surfaces.front().kernel;
    const SurfaceWay& way = way_of(kernel);
    EXPECT_FALSE(way.is_level_set());
    const UpwardRounding upward;
    const SceneRay down{
        .origin = {0.5, 0.5, 2}, .direction = UnitVector({0, 0, -1}), .from = 0, .to = 4};
    const SceneRay beside{
        .origin = {1.5, 0.5, 2}, .direction = UnitVector({0, 0, -1}), .from = 0, .to = 4};
    const auto hit = way.hit_on(kernel, scene.uniforms, down, 1e-9);
    ASSERT_TRUE(hit && hit->is_hit());
    EXPECT_EQ(hit->certificate, Certificate::Certified);
    EXPECT_NEAR(hit->t, 1.75, 1e-9);
    const auto miss = way.hit_on(kernel, scene.uniforms, beside, 1e-9);
    ASSERT_TRUE(miss);
    EXPECT_FALSE(miss->is_hit());

    const auto prepared = way.prepare(kernel, scene.uniforms);
    TraceFrame frame = trace_frame(scene, scene.surfaces.front(),
                                   ViewFrame(default_camera(scene.clip)), {64, 64}, {});
    frame.prepared = prepared.get();
    Counters counters;
    std::array<RayHit, 2> hits{};
    const std::array rays{down, beside};
    ASSERT_TRUE(way.find_first(frame, 3, rays, hits, counters));
    EXPECT_EQ(hits[0].surface, 3);
    EXPECT_NEAR(hits[0].t, 1.75, 1e-6);
    EXPECT_FALSE(hits[1].is_hit());
    std::array<std::uint8_t, 2> blocked{};
    ASSERT_TRUE(way.find_blocked(frame, 3, rays, blocked, counters));
    EXPECT_EQ(blocked[0], 1);
    EXPECT_EQ(blocked[1], 0);
}

TEST(SurfaceWays, HoldPatchesInBoxes) {
    const Scene scene = patch();
    const Kernel& kernel = scene.surfaces.front().kernel;
    const UpwardRounding upward;
    const auto boxes = way_of(kernel).boxes(kernel, scene.uniforms);
    ASSERT_TRUE(boxes && !boxes->empty());
    for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 8; ++j) {
            const glm::dvec3 at(i / 8.0, j / 8.0, i * j / 64.0);
            EXPECT_TRUE(std::ranges::any_of(*boxes,
                                            [&](const Box& box) {
                                                return glm::all(glm::lessThanEqual(box.lo, at)) &&
                                                       glm::all(glm::lessThanEqual(at, box.hi));
                                            }))
                << i << ", " << j;
        }
    }
    const Scene formula = scene_of("z = 0", Box::cube(2));
    EXPECT_FALSE(way_of(formula.surfaces[0].kernel).boxes(formula.surfaces[0].kernel, {}));
}

}  // namespace
}  // namespace zeroset::test::surface_ways_test
