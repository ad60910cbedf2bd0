#include "engine/antialias/calm_blocks.hpp"

#include "engine/real/rounding.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace zeroset::test {
namespace {

constexpr Camera camera{.eye = {0, -4, 0}, .look_at = {0, 0, 0}, .up = {0, 0, 1}, .fov_rad = 0.6};
constexpr std::size_t items = std::size_t{tile_size} * tile_size;

/// The middle tile of a picture of a sphere of radius 1/2 and of what else a text adds, all of its
/// hits on the sphere said to be calm.
class CalmTile {
public:
    explicit CalmTile(const std::string& others)
        : scene_(scene_of("(x^2 + y^2 + z^2 - 0.25)" + others + " = 0", Box::cube(1.5))),
          frame_(trace_frame(scene_, scene_.surfaces.front(), ViewFrame(camera),
                             {.width = 192, .height = 192}, {})),
          rays_(frame_, {.col = 64, .row = 64, .cols = 64, .rows = 64}) {
        for (std::size_t i = 0; i < items; ++i) {
            const auto col = static_cast<double>(i % tile_size);
            const auto row = static_cast<double>(i / tile_size);
            const glm::dvec3 origin = rays_.point(col, row, 0.0);
            const glm::dvec3 direction = rays_.point(col, row, 1.0) - origin;
            const double a = glm::dot(direction, direction);
            const double b = glm::dot(origin, direction);
            const double c = glm::dot(origin, origin) - 0.25;
            if (b * b < a * c) continue;
            const double s = (-b - std::sqrt(b * b - a * c)) / a;
            const double distance = rays_.distance_at(s, rays_.u(col), rays_.v(row));
            pixels_.push_back({.pixel = static_cast<std::uint16_t>(i),
                               .from = -100.0F,
                               .hit = static_cast<float>(distance),
                               .is_calm = true});
        }
    }
    [[nodiscard]] const TileRays& rays() const { return rays_; }
    [[nodiscard]] std::vector<MixedPixel>& pixels() { return pixels_; }
    void search() {
        const UpwardRounding upward;
        Counters counters;
        leave_calm_blocks(frame_, rays_, pixels_, counters);
    }
    [[nodiscard]] bool is_plain(int col, int row) const {
        const auto at = static_cast<std::uint16_t>(row * tile_size + col);
        return std::ranges::find(pixels_, at, &MixedPixel::pixel)->is_plain;
    }
    [[nodiscard]] std::size_t plain_count() const {
        return static_cast<std::size_t>(std::ranges::count(pixels_, true, &MixedPixel::is_plain));
    }

private:
    Scene scene_;
    TraceFrame frame_;
    TileRays rays_;
    std::vector<MixedPixel> pixels_;
};

TEST(CalmBlocks, ArePlainWhereNothingIsBeforeTheirSheet) {
    CalmTile tile("");
    tile.search();
    ASSERT_EQ(tile.pixels().size(), items);
    EXPECT_EQ(tile.plain_count(), items);
}

TEST(CalmBlocks, AreSearchedWhereSomethingSmallGoesBetweenTheirRays) {
    // A ball of a sixth of a pixel's radius, between the centres of four pixels.
    const glm::dvec3 at = CalmTile("").rays().point(20.5, 30.5, -0.8);
    const auto square = [](const char* axis, double middle) {
        return "(" + std::string(axis) + " - (" + std::to_string(middle) + "))^2";
    };
    CalmTile tile("*(" + square("x", at.x) + "+" + square("y", at.y) + "+" + square("z", at.z) +
                  " - 0.000004)");
    tile.search();
    for (const int col : {20, 21})
        for (const int row : {30, 31})
            EXPECT_FALSE(tile.is_plain(col, row)) << col << " " << row;
    EXPECT_GT(tile.plain_count(), items / 2);
}

TEST(CalmBlocks, AreSearchedWhereTheirHitsAreNotWhatIsMetFirst) {
    CalmTile tile("");
    for (MixedPixel& pixel : tile.pixels()) {
        // As if the hits of every fourth pair of rows were on the sphere's far side.
        if (pixel.pixel / tile_size / 2 % 4 == 0) pixel.hit += 0.6F;
    }
    tile.search();
    for (const MixedPixel& pixel : tile.pixels())
        EXPECT_EQ(pixel.is_plain, pixel.pixel / tile_size / 2 % 4 != 0) << pixel.pixel;
}

TEST(CalmBlocks, AreOfCalmPixelsThatAreNotDividedInAnyCase) {
    CalmTile tile("");
    std::vector<MixedPixel>& pixels = tile.pixels();
    for (MixedPixel& pixel : pixels) {
        const int col = pixel.pixel % tile_size;
        pixel.is_calm = col >= 16;
        if (col >= 32 && col < 40) pixel.least_level = 2;
        if (col >= 48) pixel.sheet_to = 10.0F;
    }
    tile.search();
    for (const MixedPixel& pixel : pixels) {
        const int col = pixel.pixel % tile_size;
        const bool may_be = (col >= 16 && col < 32) || (col >= 40 && col < 48);
        EXPECT_EQ(pixel.is_plain, may_be) << pixel.pixel;
    }
}

}  // namespace
}  // namespace zeroset::test
