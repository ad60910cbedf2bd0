#include "engine/scene/region.hpp"

#include "engine/real/rounding.hpp"
#include "engine/trace/tile_rays.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// Where rays are inside a region: enclosures of tiles and pixels against the points themselves.

namespace zeroset::test::region_test {
namespace {

TEST(Section, HasANormalOfLengthOne) {
    const Section section = make_section({3, 0, -4}, 10, false);
    EXPECT_EQ(section.normal, glm::dvec3(0.6, 0, -0.8));
    EXPECT_EQ(section.offset, 2.0);
    EXPECT_FALSE(section.cap);
}

TEST(Region, HoldsWhatTheBallAndAllSectionsKeep) {
    const Region region{.ball = Ball{.centre = {1, 0, 0}, .radius = 2},
                        .sections = {make_section({0, 0, 1}, 0.5), make_section({0, -1, 0}, 0)}};
    EXPECT_TRUE(region.contains({1, 1, 0.5}));
    EXPECT_FALSE(region.contains({1, 1, 0.51}));
    EXPECT_TRUE(region.contains({1, 1, 0.51}, 0.02));
    EXPECT_FALSE(region.contains({1, -0.1, 0}));
    EXPECT_TRUE(region.contains({3, 0, 0}));
    EXPECT_FALSE(region.contains({3.1, 0, 0}));
    EXPECT_TRUE(region.contains({3.1, 0, 0}, 0.2));
    EXPECT_TRUE(Region().contains({1e9, 0, 0}));
}

TEST(Section, CutsABoxOfWhichItTakesSomething) {
    const Box box{{-1, -2, -3}, {1, 2, 3}};
    EXPECT_TRUE(cuts(make_section({1, 0, 0}, 0.999), box));
    EXPECT_FALSE(cuts(make_section({1, 0, 0}, 1), box));
    EXPECT_FALSE(cuts(make_section({0, 0, -1}, 3), box));
    EXPECT_TRUE(cuts(make_section({1, 1, 1}, 5.9), box));
    EXPECT_FALSE(cuts(make_section({1, 1, 1}, 6), box));
    EXPECT_TRUE(cuts(make_section({1, 0, 0}, -5), box)) << "it takes all";
}

Region random_region(RandomNumbers& random) {
    const auto number = [&] { return random.uniform(-1.5, 1.5); };
    Region region;
    if (random.one_in(2))
        region.ball = Ball{{number(), number(), number()}, random.uniform(0.3, 3)};
    const int sections = random.between(0, 3);
    for (int i = 0; i < sections; ++i) {
        glm::dvec3 normal(number(), number(), number());
        if (random.one_in(3)) normal = {0, i == 1 ? 1 : 0, i == 1 ? 0 : -1};
        region.sections.push_back(make_section(normal, number()));
    }
    return region;
}

Camera random_view(RandomNumbers& random) {
    Camera camera = default_camera(Box::cube(random.uniform(0.5, 3)));
    camera = orbit(camera, random.uniform(-3, 3), random.uniform(-1, 1));
    if (random.one_in(4)) camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.7};
    if (random.one_in(3)) camera = zoom(camera, random.uniform(0.01, 0.5), camera.look_at);
    if (random.one_in(2)) camera.projection = Projection::Orthographic;
    return camera;
}

/// How far inside a place is: below 0 if it is outside.
double depth_in(const Scene& scene, const glm::dvec3& p) {
    double least = infinity;
    for (int i = 0; i < 3; ++i)
        least = std::min({least, p[i] - scene.clip.lo[i], scene.clip.hi[i] - p[i]});
    for (const Section& section : scene.region.sections)
        least = std::min(least, section.offset - glm::dot(section.normal, p));
    if (const auto& ball = scene.region.ball)
        least = std::min(least, ball->radius - glm::distance(p, ball->centre));
    return least;
}

TEST(TileRays, EnclosesWhereRaysAreInside) {
    const UpwardRounding upward;
    RandomNumbers random(7);
    std::size_t inside = 0;
    std::size_t sure = 0;
    for (int i = 0; i < 400; ++i) {
        Scene scene{{}, Box::cube(2), {}};
        scene.region = random_region(random);
        const ViewFrame camera(random_view(random));
        const int height = random.between(64, 600);
        const TraceFrame frame =
            trace_frame(scene, Surface{}, camera, {.width = height, .height = height}, {});
        const Tile tile{random.between(0, height - 64), random.between(0, height - 64), 64, 64};
        const TileRays view(frame, tile);
        const int pixels = random.one_in(2) ? 1 : 8 << random.between(0, 3);
        const double half = 0.5 * (pixels - 1);
        const double radius = half * view.pixel();
        const DepthRange range = view.depths(view.u(half), view.v(half), radius, radius);
        for (int point = 0; point < 200; ++point) {
            const int col = random.between(0, pixels - 1);
            const int row = random.between(0, pixels - 1);
            const double s = random.uniform(-12, 6);
            if (!camera.parallel() && s < -camera.look_distance) continue;
            const glm::dvec3 p = view.point(col, row, s);
            const double depth = depth_in(scene, p);
            if (depth > 1e-12) {
                ++inside;
                EXPECT_GE(s, range.enter_lo);
                EXPECT_LE(s, range.exit_hi);
            }
            if (s >= range.enter_hi && s <= range.exit_lo) {
                ++sure;
                EXPECT_GT(depth, -1e-12);
            }
            const glm::dvec3 on_ray = camera.point(pixel_centre(tile.col + col, tile.row + row),
                                                   {.width = height, .height = height},
                                                   view.distance_at(s, view.u(col), view.v(row)));
            EXPECT_LT(glm::distance(p, on_ray), 1e-12);
        }
    }
    EXPECT_GT(inside, 1500U);
    EXPECT_GT(sure, 1000U);
}

/// The bounds of single rays are as near as rounding allows.
TEST(TileRays, KnowsWhereARayEntersAndLeaves) {
    const UpwardRounding upward;
    RandomNumbers random(11);
    std::size_t met = 0;
    for (int i = 0; i < 300; ++i) {
        Scene scene{{}, Box::cube(2), {}};
        scene.region = random_region(random);
        const Camera camera = random_view(random);
        const ViewFrame frame_view(camera);
        const Framebuffer image(200, 200);
        const TraceFrame frame =
            trace_frame(scene, Surface{}, frame_view, {.width = 200, .height = 200}, {});
        const Tile tile{random.between(0, 136), random.between(0, 136), 64, 64};
        const TileRays view(frame, tile);
        for (int col = 0; col < 64; col += 3) {
            const int row = random.between(0, 63);
            const Ray ray(camera, scene.clip, tile.col + col, tile.row + row, image, scene.region);
            if (!(ray.t_in < ray.t_out - 1e-3)) continue;
            ++met;
            const double u = view.u(col);
            const double v = view.v(row);
            const DepthRange range = view.depths(u, v, 0, 0);
            EXPECT_NEAR(view.distance_at(range.enter_lo, u, v), ray.t_in, 1e-9);
            EXPECT_NEAR(view.distance_at(range.enter_hi, u, v), ray.t_in, 1e-9);
            EXPECT_NEAR(view.distance_at(range.exit_lo, u, v), ray.t_out, 1e-9);
            EXPECT_NEAR(view.distance_at(range.exit_hi, u, v), ray.t_out, 1e-9);
        }
    }
    EXPECT_GT(met, 500U);
}

}  // namespace
}  // namespace zeroset::test::region_test
