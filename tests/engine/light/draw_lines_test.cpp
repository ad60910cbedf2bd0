#include "engine/image/gamma.hpp"
#include "engine/render/render.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

// Lines on surfaces, by where they must be.

namespace zeroset::test::draw_lines_test {
namespace {

constexpr int side = 200;

/// A plane seen from above: two units of the world across the picture.
Scene plane() { return scene_of("z = 0", Box::cube(2)); }
Camera from_above() {
    return {.eye = {0, 0, 5},
            .look_at = {0, 0, 0},
            .up = {0, 1, 0},
            .fov_rad = 2.0 * std::atan(1.0 / 5.0),
            .projection = Projection::Orthographic};
}

Framebuffer picture_of(const Scene& scene, const Camera& camera,
                       Antialias antialias = Antialias::None) {
    Framebuffer frame(side, side);
    TraceSettings settings;
    settings.antialias = antialias;
    render_frame(scene, camera, settings, frame);
    return frame;
}

/// The part of a pixel that a line covers: how much darker it is than without lines.
double cover_at(const Framebuffer& with, const Framebuffer& without, int col, int row) {
    const std::size_t at = with.index(col, row);
    const auto light = [&](const Framebuffer& frame) {
        return static_cast<double>(light_of_channel(frame.color[at] >> 8U & 0xFFU));
    };
    return (1.0 - light(with) / light(without)) / 0.96;
}

TEST(Lines, OfXAreWhereItIsAMultipleOfTheStepAsWideAsAskedFor) {
    Scene scene = plane();
    const Framebuffer without = picture_of(scene, from_above());
    for (const float width : {0.5F, 1.4F, 4.0F}) {
        scene.coloring.lines = {
            .contours = {{.along = {1, 0, 0}}}, .step = 0.25, .width_px = width};
        const Framebuffer with = picture_of(scene, from_above());
        double covered = 0.0;
        for (int col = 0; col < side; ++col) {
            const double x = (col + 0.5 - 0.5 * side) * 2.0 / side;
            const double distance = std::abs(x - 0.25 * std::round(4.0 * x)) * 0.5 * side;
            const double cover = cover_at(with, without, col, side / 2);
            covered += cover;
            if (distance > 0.5 * static_cast<double>(width) + 0.6) {
                EXPECT_NEAR(cover, 0.0, 0.02) << col;
            }
            EXPECT_NEAR(cover, cover_at(with, without, col, 3), 0.02);
        }
        // Seven whole lines and two halves at the picture's edges.
        EXPECT_NEAR(covered, 8.0 * static_cast<double>(width), 0.08 * 8.0);
    }
}

TEST(Lines, AreAsWideInFinerPictures) {
    Scene scene = plane();
    scene.coloring.lines = {.contours = {{.along = {1, 0, 0}}}, .step = 0.5, .width_px = 3.0F};
    const Framebuffer plain = picture_of(scene, from_above());
    const Framebuffer fine = picture_of(scene, from_above(), Antialias::Rays16);
    for (int col = 0; col < side; ++col) {
        const std::size_t at = plain.index(col, side / 2);
        const auto green = [&](const Framebuffer& frame) {
            return static_cast<double>(light_of_channel(frame.color[at] >> 8U & 0xFFU));
        };
        EXPECT_NEAR(green(plain), green(fine), 0.03) << col;
    }
}

TEST(Lines, TooCloseToBeToldApartFade) {
    Scene scene = plane();
    const Framebuffer without = picture_of(scene, from_above());
    scene.coloring.lines = {.contours = {{.along = {1, 0, 0}}}, .step = 0.005};
    EXPECT_EQ(picture_of(scene, from_above()).color, without.color);
}

TEST(Lines, AreDrawnWhereSurfacesMeet) {
    Scene scene = plane();
    scene.surfaces.push_back(scene_of("x^2 + y^2 + (z + 0.5)^2 = 0.5", Box::cube(2)).surfaces[0]);
    const Framebuffer without = picture_of(scene, from_above());
    scene.coloring.lines.intersections = true;
    const Framebuffer with = picture_of(scene, from_above());
    std::size_t on_line = 0;
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col) {
            const double x = (col + 0.5 - 0.5 * side) * 2.0 / side;
            const double y = (0.5 * side - row - 0.5) * 2.0 / side;
            const double from_circle = std::abs(std::hypot(x, y) - 0.5) * 0.5 * side;
            const double cover = cover_at(with, without, col, row);
            if (from_circle > 3.0) {
                ASSERT_NEAR(cover, 0.0, 0.02) << col << ", " << row;
            }
            if (from_circle < 0.5) {
                ASSERT_GT(cover, 0.5) << col << ", " << row;
                ++on_line;
            }
        }
    }
    EXPECT_GT(on_line, 200U);
}

/// The technical look's creases on a roof, seen from above: its ridge at an angle to the pixels.
TEST(Lines, OfTheTechnicalLookAreAsWideAtCreasesAsAskedForAndSmooth) {
    constexpr double slope = 0.2;  // the ridge is at y = slope x
    Scene scene = scene_of("z = -abs(y - 0.2 x)", Box::cube(2));
    scene.lighting.look = Look::Technical;
    for (const Antialias antialias : {Antialias::None, Antialias::Beams}) {
        for (const float width : {1.4F, 3.0F}) {
            scene.coloring.lines.width_px = width;
            const Framebuffer frame = picture_of(scene, from_above(), antialias);
            double least = 1e9;
            double most = 0.0;
            for (int col = 20; col < side - 20; ++col) {
                const auto light_at = [&](int row) {
                    return static_cast<double>(
                        light_of_channel(frame.color[frame.index(col, row)] >> 8U & 0xFFU));
                };
                const double x = (col + 0.5 - 0.5 * side) * 2.0 / side;
                const double place = 0.5 * side - slope * x * 0.5 * side;
                const int ridge = static_cast<int>(place);
                double covered = 0.0;
                for (int row = ridge - 6; row <= ridge + 6; ++row) {
                    const double bare = light_at(row + 0.5 < place ? ridge - 10 : ridge + 10);
                    covered += 1.0 - light_at(row) / bare;
                }
                least = std::min(least, covered);
                most = std::max(most, covered);
            }
            // Ink leaves some light, and the ridge's pixels may be bare as either side is.
            const double across = static_cast<double>(width) * std::hypot(1.0, slope);
            EXPECT_GT(least, 0.8 * across) << width;
            EXPECT_LT(most, 1.15 * across) << width;
        }
    }
}

TEST(Lines, OfTheTechnicalLookFollowTheSilhouette) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = 0.64", Box::cube(2));
    scene.lighting.look = Look::Technical;
    const Framebuffer frame = picture_of(scene, from_above());
    const auto light_at = [&](double radius, double angle) {
        const int col = static_cast<int>(0.5 * side * (1.0 + radius * std::cos(angle)));
        const int row = static_cast<int>(0.5 * side * (1.0 - radius * std::sin(angle)));
        return light_of_channel(frame.color[frame.index(col, row)] >> 8U & 0xFFU);
    };
    for (int k = 0; k < 24; ++k) {
        const double angle = 0.1 + k * 0.26;
        EXPECT_LT(light_at(0.795, angle), 0.5F * light_at(0.7, angle)) << angle;
    }
}

}  // namespace
}  // namespace zeroset::test::draw_lines_test
