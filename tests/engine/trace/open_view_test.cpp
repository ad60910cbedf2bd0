#include "engine/trace/open_view.hpp"

#include "tests/support/random_numbers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Open cells as views show them: each ray through one sees it.

namespace zeroset::test::open_view_test {
namespace {

Camera random_camera(RandomNumbers& random) {
    const auto number = [&] { return random.uniform(-1, 1); };
    Camera camera;
    camera.look_at = {number(), number(), number()};
    camera.eye = camera.look_at + std::exp2(random.uniform(-2, 4)) *
                                      glm::normalize(glm::dvec3(number(), number(), number()));
    camera.up = {number(), number(), number()};
    camera.fov_rad = random.uniform(0.1, 2.0);
    if (random.one_in(3)) camera.projection = Projection::Orthographic;
    return camera;
}

TEST(OpenView, ShowsOpenCellsOnAllRaysThroughThem) {
    RandomNumbers random(22);
    const Scene scene = scene_of("x + y + z", Box{{-2, -1, -1}, {1, 2, 1}});
    const ImageSize image{.width = 150, .height = 90};
    constexpr int side = 16;
    int seen = 0;
    for (int i = 0; i < 400; ++i) {
        const Camera camera = random_camera(random);
        if (camera_defect(camera) != nullptr) continue;
        const ViewFrame view(camera);
        const TraceFrame frame = trace_frame(scene, scene.surfaces.front(), view, image, {});
        const auto cell = static_cast<std::uint32_t>(random.below(side * side * side));
        const OpenView open(frame, {.box = scene.clip, .side = side, .cells = {cell}});
        const glm::dvec3 size = (scene.clip.hi - scene.clip.lo) / double{side};
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 in_cell(cell % side + random.uniform(),
                                     cell / side % side + random.uniform(),
                                     cell / side / side + random.uniform());
            const glm::dvec3 point = scene.clip.lo + in_cell * size;
            const glm::dvec3 place = view.homogeneous(point);
            if (!(place.z > 0)) continue;
            const double half = 0.5 * image.height;
            const double col = 0.5 * image.width + half * place.x / place.z;
            const double row = half - half * place.y / place.z;
            if (!(col >= 0 && col < image.width && row >= 0 && row < image.height)) continue;
            ++seen;
            const double s = glm::dot(point - view.eye, view.forward) - view.look_distance;
            const int c = static_cast<int>(col);
            const int r = static_cast<int>(row);
            ASSERT_TRUE(open.may_hold(c, r, s, s)) << i;
            ASSERT_TRUE(open.may_hold(c, r, s - 1, s + 0.5)) << i;
        }
    }
    EXPECT_GT(seen, 500);
}

TEST(OpenView, LeavesOutTheRest) {
    const Scene scene = scene_of("x", Box::cube(1));
    const ViewFrame view(suite_camera(1));
    const TraceFrame frame =
        trace_frame(scene, scene.surfaces.front(), view, {.width = 512, .height = 512}, {});
    const OpenView nothing(frame, {.box = scene.clip, .side = 32, .cells = {}});
    EXPECT_FALSE(nothing.may_hold(192, 192, -2, 2));
    constexpr std::uint32_t middle = 16 + 32 * (16 + 32 * 16);
    const OpenView one(frame, {.box = scene.clip, .side = 32, .cells = {middle}});
    EXPECT_TRUE(one.may_hold(256, 256, -2, 2) || one.may_hold(192, 192, -2, 2));
    EXPECT_FALSE(one.may_hold(0, 0, -2, 2));
    EXPECT_FALSE(one.may_hold(320, 320, -2, 2));
    EXPECT_FALSE(one.may_hold(256, 256, -2, -0.5));
    EXPECT_FALSE(one.may_hold(256, 256, 0.5, 2));
}

}  // namespace
}  // namespace zeroset::test::open_view_test
