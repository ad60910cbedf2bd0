#include "engine/scene/coloring.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/render/color_range.hpp"
#include "engine/render/render.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "engine/view/pixel_ray.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Colours, pixel by pixel: as bright as a plain surface whose sides have that colour.

namespace zeroset::test::coloring_test {
namespace {

constexpr int side = 72;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Framebuffer picture_of(const Scene& scene, const TraceSettings& settings) {
    Framebuffer frame(side, side);
    render_frame(scene, default_camera(scene.clip), settings, frame);
    return frame;
}

TraceSettings usual() { return settings_at("beams", 16); }

/// Both sides of every surface in one colour.
Scene painted(Scene scene, const Reflectance& color) {
    SurfaceColors both{};
    std::ranges::copy(color, both.front);
    std::ranges::copy(color, both.back);
    scene.coloring = {};
    for (Surface& surface : scene.surfaces)
        surface.colors = both;
    return scene;
}

int channel(std::uint32_t color, unsigned index) {
    return static_cast<int>(color >> (8U * index) & 0xFFU);
}

/// Expects the pixel as if its surface were painted in `color`.
void expect_color(const Framebuffer& frame, const Scene& scene, int col, int row,
                  const Reflectance& color) {
    const Framebuffer plain = picture_of(painted(scene, color), usual());
    const std::size_t at = frame.index(col, row);
    ASSERT_NE(frame.surface[at], no_surface);
    for (unsigned i = 0; i < 3; ++i)
        EXPECT_NEAR(channel(frame.color[at], i), channel(plain.color[at], i), 1)
            << "channel " << i << " at " << col << ", " << row;
}

glm::dvec3 point_at(const Framebuffer& frame, const Scene& scene, int col, int row) {
    const ViewFrame view(default_camera(scene.clip));
    const auto depth = static_cast<double>(frame.depth[frame.index(col, row)]);
    return pixel_ray(view, pixel_centre(col, row), {.width = frame.width, .height = frame.height})
        .at(depth);
}

constexpr std::array<std::array<int, 2>, 4> places{{{36, 36}, {25, 30}, {44, 22}, {33, 50}}};

TEST(ColorBy, NormalsAreDirectionsOfTheGradient) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    scene.coloring.by = ColorBy::Normal;
    const Framebuffer frame = picture_of(scene, usual());
    for (const auto& [col, row] : places) {
        const glm::dvec3 shown = 0.5 * (glm::normalize(point_at(frame, scene, col, row)) + 1.0);
        const glm::dvec3 color = shown * shown;
        expect_color(frame, scene, col, row,
                     {static_cast<float>(color.x), static_cast<float>(color.y),
                      static_cast<float>(color.z)});
    }
}

TEST(ColorBy, HeightAndDepthAreInTheRange) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    scene.coloring.range = ValueRange{-0.8, 0.9};
    for (const glm::dvec3& up : {glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0)}) {
        scene.coloring.by = ColorBy::Height;
        scene.coloring.up = up;
        const Framebuffer frame = picture_of(scene, usual());
        for (const auto& [col, row] : places) {
            const double height = glm::dot(up, point_at(frame, scene, col, row));
            expect_color(frame, scene, col, row, color_at(ColorMap::Aurora, (height + 0.8) / 1.7));
        }
    }
    scene.coloring.by = ColorBy::Depth;
    scene.coloring.map = ColorMap::Ember;
    scene.coloring.range = ValueRange{3.0, 5.0};
    const Framebuffer frame = picture_of(scene, usual());
    for (const auto& [col, row] : places) {
        const auto depth = static_cast<double>(frame.depth[frame.index(col, row)]);
        expect_color(frame, scene, col, row, color_at(ColorMap::Ember, (depth - 3.0) / 2.0));
    }
}

TEST(ColorBy, CurvatureIsThatOfEachSurface) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    scene.surfaces.push_back(scene_of("(x-1)^2 + (y+1)^2 + z^2 = 0.16", scene.clip).surfaces[0]);
    const auto curvature = [](const char* text) {
        return interpret_points(mean_curvature(*parse(text)));
    };
    scene.coloring.by = ColorBy::MeanCurvature;
    scene.coloring.map = ColorMap::Balance;
    scene.coloring.range = ValueRange{-4, 4};
    scene.coloring.values = {curvature("x^2 + y^2 + z^2 = 1"),
                             curvature("(x-1)^2 + (y+1)^2 + z^2 = 0.16")};
    const Framebuffer frame = picture_of(scene, usual());
    std::array<bool, 2> seen{};
    for (int row = 4; row < side; row += 9) {
        for (int col = 4; col < side; col += 9) {
            const std::uint8_t surface = frame.surface[frame.index(col, row)];
            if (surface == no_surface) continue;
            const double mean = surface == 0 ? 1.0 : 2.5;
            expect_color(frame, scene, col, row, color_at(ColorMap::Balance, (mean + 4) / 8));
            seen.at(surface) = true;
        }
    }
    EXPECT_TRUE(seen[0] && seen[1]);
}

TEST(ColorBy, ShadowsAndSmoothEdgesStay) {
    Scene scene = scene_of("min(z + 0.5, x^2 + y^2 + (z-0.4)^2 - 0.1)", Box::cube(1));
    scene.coloring.by = ColorBy::Expression;
    scene.coloring.range = ValueRange{0, 1};
    scene.coloring.values = {interpret_points(*parse("0.3"))};
    TraceSettings settings = usual();
    settings.shadows = true;
    settings.antialias = Antialias::Beams;
    const Framebuffer frame = picture_of(scene, settings);
    const Framebuffer plain = picture_of(painted(scene, color_at(ColorMap::Aurora, 0.3)), settings);
    EXPECT_EQ(frame.color, plain.color);
    EXPECT_EQ(frame.depth, plain.depth);
}

TEST(ColorBy, WhatIsNoNumberIsGrey) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    scene.coloring.by = ColorBy::Expression;
    scene.coloring.range = ValueRange{0, 1};
    scene.coloring.values = {interpret_points(*parse("sqrt(0 - x^2 - 1)"))};
    const Framebuffer frame = picture_of(scene, usual());
    expect_color(frame, scene, 36, 36, color_at(ColorMap::Aurora, nan));
}

TEST(FittingRange, LeavesOutOutliersAndRoundsOutward) {
    std::vector<double> values;
    for (int i = 0; i <= 1000; ++i)
        values.push_back(0.001 * i);
    values.push_back(1e9);
    values.push_back(-1e9);
    values.push_back(nan);
    const ValueRange range = fitting_range(values, false);
    EXPECT_NEAR(range.lo, 0.01, 1e-12);  // of 0.019
    EXPECT_NEAR(range.hi, 0.99, 1e-12);  // of 0.981
    const ValueRange signed_range = fitting_range(values, true);
    EXPECT_EQ(signed_range.lo, -signed_range.hi);
    EXPECT_NEAR(signed_range.hi, 1.0, 1e-12);
}

TEST(FittingRange, OfFewOrEqualValuesIsARange) {
    EXPECT_EQ(fitting_range({}, false), (ValueRange{0, 1}));
    EXPECT_EQ(fitting_range({nan}, true), (ValueRange{-1, 1}));
    const ValueRange same = fitting_range({3, 3, 3}, false);
    EXPECT_LT(same.lo, 3);
    EXPECT_GT(same.hi, 3);
    const ValueRange zero = fitting_range({0, 0}, false);
    EXPECT_LT(zero.lo, zero.hi);
}

TEST(FindRange, IsOfWhatThePictureShows) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    scene.coloring.by = ColorBy::Height;
    const auto range = find_range(scene, default_camera(scene.clip), usual(), 1280, 800);
    ASSERT_TRUE(range.has_value());
    EXPECT_GT(range->hi, 0.85);
    EXPECT_LE(range->hi, 1.0);
    EXPECT_LT(range->lo, -0.4);
    EXPECT_GE(range->lo, -1.0);
}

TEST(SteadyRange, StaysUntilItNoLongerFits) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    scene.coloring.by = ColorBy::Height;
    SteadyRange steady;
    EXPECT_EQ(steady.last(scene), std::nullopt);
    EXPECT_EQ(steady.after(scene, {0, 1}), (ValueRange{0, 1}));
    EXPECT_EQ(steady.after(scene, {0.1, 1.2}), (ValueRange{0, 1}));
    EXPECT_EQ(steady.after(scene, {0, 2}), (ValueRange{0, 2}));
    EXPECT_EQ(steady.last(scene), (ValueRange{0, 2}));
    scene.coloring.by = ColorBy::Depth;
    EXPECT_EQ(steady.last(scene), std::nullopt);
}

}  // namespace
}  // namespace zeroset::test::coloring_test
