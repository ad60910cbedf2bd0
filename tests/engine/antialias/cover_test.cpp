#include "engine/antialias/cover_search.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/tile_grid.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

// The parts of pixels that surfaces cover, against closed forms.

namespace zeroset::test::cover_test {
namespace {

constexpr int side = 40;              ///< of the pictures, in pixels
constexpr double pixel = 2.0 / side;  ///< of the world, whose unit square they show
constexpr double most_error = 1.0 / 256;

/// Looks down the z axis, with parallel rays: column c shows x = (c - side / 2) pixel.
Camera from_above() {
    return {.eye = {0, 0, 2},
            .look_at = {0, 0, 0},
            .up = {0, 1, 0},
            .fov_rad = 2.0 * std::atan(0.5),
            .projection = Projection::Orthographic};
}

constexpr float none = std::numeric_limits<float>::infinity();

/// The part of each pixel that the scene covers; `calm_hit`: how far the hits of their own rays
/// are, if they are calm.
std::vector<double> cover_of(const Scene& scene, float calm_hit = none) {
    const ViewFrame view(from_above());
    const UpwardRounding upward;
    const std::vector<TraceFrame> frames{
        trace_frame(scene, scene.surfaces.front(), view, {.width = side, .height = side}, {})};
    const Tile tile{.col = 0, .row = 0, .cols = side, .rows = side};
    std::vector<MixedPixel> pixels;
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col)
            pixels.push_back({.pixel = static_cast<std::uint16_t>(row * tile_size + col),
                              .from = -none,
                              .hit = calm_hit,
                              .is_calm = calm_hit < none});
    }
    std::vector<CoverSample> samples;
    Counters counters;
    find_cover(frames, tile, pixels, samples, counters);
    const auto at = [](std::uint16_t of) {
        return static_cast<std::size_t>(of / tile_size * side + of % tile_size);
    };
    // Plain pixels are left out.
    std::vector<double> cover(std::size_t{side} * side, 1.0);
    for (const MixedPixel& mixed : pixels)
        cover[at(mixed.pixel)] = 0.0;
    for (const CoverSample& sample : samples)
        cover[at(sample.pixel)] += static_cast<double>(sample.area);
    return cover;
}

/// The part of a pixel that a convex shape covers. `shape(x)`: where its y begins and ends.
double area_in(int col, int row, const auto& shape) {
    constexpr int slices = 4000;
    const double left = (col - side / 2) * pixel;
    const double bottom = (side / 2 - row - 1) * pixel;
    double sum = 0.0;
    for (int i = 0; i < slices; ++i) {
        const std::pair<double, double> y = shape(left + (i + 0.5) / slices * pixel);
        sum += std::max(0.0, std::min(y.second, bottom + pixel) - std::max(y.first, bottom));
    }
    return sum / slices / pixel;
}

void expect_cover(const Scene& scene, const auto& shape, const std::string& what) {
    const std::vector<double> cover = cover_of(scene);
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col) {
            const double found = cover[static_cast<std::size_t>(row * side + col)];
            ASSERT_NEAR(found, area_in(col, row, shape), most_error)
                << what << " at " << col << ", " << row;
        }
    }
}

std::string text_of(double number) { return "(" + std::to_string(number) + ")"; }

class Cover : public testing::Test {
protected:
    double between(double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random_);
    }

private:
    std::mt19937 random_{3};
};

TEST(CoverOfCalmPixels, HasTheGapsThatTheirOwnRaysPassBy) {
    constexpr double width = 0.9;  // in pixels, between the centres of two columns
    const Scene slab =
        scene_of("max(abs(z) - 0.02, " + std::to_string(0.5 * width * pixel) + " - abs(x)) = 0",
                 Box::cube(1.5));
    const std::vector<double> cover = cover_of(slab, 1.98F);
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col) {
            const bool beside = col == side / 2 - 1 || col == side / 2;
            ASSERT_NEAR(cover[static_cast<std::size_t>(row * side + col)],
                        beside ? 1.0 - 0.5 * width : 1.0, most_error)
                << col << ", " << row;
        }
    }
}

TEST_F(Cover, OfADisc) {
    for (int i = 0; i < 6; ++i) {
        const double a = between(-0.2, 0.2);
        const double b = between(-0.2, 0.2);
        const double r = between(3.0, 14.0) * pixel;
        const std::string text =
            "(x-" + text_of(a) + ")^2 + (y-" + text_of(b) + ")^2 + z^2 = " + text_of(r) + "^2";
        const auto disc = [&](double x) {
            const double half = std::sqrt(std::max(0.0, r * r - (x - a) * (x - a)));
            return std::pair(b - half, b + half);
        };
        expect_cover(scene_of(text, Box::cube(1.5)), disc, text);
    }
}

/// The y for which n . (x, y) <= offset.
auto half_plane(double angle, double offset) {
    return [=](double x) {
        const double end = (offset - x * std::cos(angle)) / std::sin(angle);
        return std::sin(angle) > 0.0 ? std::pair(-2.0, end) : std::pair(end, 2.0);
    };
}

TEST_F(Cover, OfAHalfPlaneThatIsCutOff) {
    for (int i = 0; i < 6; ++i) {
        const double angle = between(-3.0, 3.0);
        const double offset = between(-0.5, 0.5);
        Scene scene = scene_of("z = 0.1 x", Box::cube(1.5));
        scene.region.sections.push_back(
            {.normal = {std::cos(angle), std::sin(angle), 0}, .offset = offset, .cap = false});
        expect_cover(scene, half_plane(angle, offset), "angle " + std::to_string(angle));
    }
}

TEST_F(Cover, OfAHalfPlaneThatIsCutOffAslant) {
    for (const double z : {-0.6, 0.6}) {
        for (int i = 0; i < 4; ++i) {
            const double angle = between(-3.0, 3.0);
            const double offset = between(-0.4, 0.4);
            Scene scene = scene_of("z = 0.1 x", Box::cube(1.5));
            const double across = std::sqrt(1.0 - z * z);
            const glm::dvec3 normal(across * std::cos(angle), across * std::sin(angle), z);
            scene.region.sections.push_back({.normal = normal, .offset = offset, .cap = false});
            // On the surface z is 0.1 x.
            const auto part = [&](double x) {
                const double end = (offset - (normal.x + 0.1 * normal.z) * x) / normal.y;
                return normal.y > 0.0 ? std::pair(-2.0, end) : std::pair(end, 2.0);
            };
            expect_cover(scene, part,
                         "z " + std::to_string(z) + ", angle " + std::to_string(angle));
        }
    }
}

TEST_F(Cover, OfAHalfPlaneThatIsASolidsFace) {
    for (int i = 0; i < 6; ++i) {
        const double angle = between(-3.0, 3.0);
        const double offset = between(-0.5, 0.5);
        const std::string text = "max(abs(z) - 0.3, " + text_of(std::cos(angle)) + "x + " +
                                 text_of(std::sin(angle)) + "y - " + text_of(offset) + ")";
        expect_cover(scene_of(text, Box::cube(1.5)), half_plane(angle, offset), text);
    }
}

TEST_F(Cover, OfALineOfASixteenthOfAPixel) {
    for (int i = 0; i < 6; ++i) {
        const double angle = between(0.2, 3.0);
        const double offset = between(-0.4, 0.4);
        const double half = pixel / 32;
        const std::string text = "(" + text_of(std::cos(angle)) + "x + " +
                                 text_of(std::sin(angle)) + "y - " + text_of(offset) +
                                 ")^2 + z^2 = " + std::to_string(half) + "^2";
        const auto line = [&](double x) {
            return std::pair((offset - half - x * std::cos(angle)) / std::sin(angle),
                             (offset + half - x * std::cos(angle)) / std::sin(angle));
        };
        expect_cover(scene_of(text, Box::cube(1.5)), line, text);
    }
}

TEST_F(Cover, OfAThreadWithoutWidthIsUnbroken) {
    for (int i = 0; i < 6; ++i) {
        const double angle = between(0.2, 3.0);
        const double offset = between(-0.4, 0.4);
        const std::string text = "(" + text_of(std::cos(angle)) + "x + " +
                                 text_of(std::sin(angle)) + "y - " + text_of(offset) +
                                 ")^2 + z^2 = 0";
        const std::vector<double> cover = cover_of(scene_of(text, Box::cube(1.5)));
        constexpr double half = 0.01 * pixel;
        const auto line = [&](double x) {
            return std::pair((offset - half - x * std::cos(angle)) / std::sin(angle),
                             (offset + half - x * std::cos(angle)) / std::sin(angle));
        };
        for (int row = 0; row < side; ++row) {
            for (int col = 0; col < side; ++col) {
                const double length = area_in(col, row, line) / 0.02;  // in pixels
                const double found = cover[static_cast<std::size_t>(row * side + col)];
                ASSERT_NEAR(found, 0.125 * length, 0.02) << text << " at " << col << ", " << row;
            }
        }
    }
}

TEST_F(Cover, OfWhatIsNotThereIsNothing) {
    for (const char* const text : {"x^2 + y^2 + z^2 = -1", "z = 5", "1 + exp(x)"}) {
        for (const double part : cover_of(scene_of(text, Box::cube(1.5))))
            ASSERT_EQ(part, 0.0) << text;
    }
}

}  // namespace
}  // namespace zeroset::test::cover_test
