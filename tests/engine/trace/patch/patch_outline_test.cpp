#include "engine/trace/patch/patch_outline.hpp"

#include "engine/real/rounding.hpp"
#include "engine/trace/patch/patch_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

// Outlines hold the pixels that may see a part, and not many others.

namespace zeroset::test::patch_outline_test {
namespace {

constexpr int side = 64;
constexpr TileRect whole{.col = 0, .row = 0, .end_col = side, .end_row = side};
constexpr double distance = 6.0;
constexpr PixelGrid grid{.u = -0.05, .v = 0.05, .pixel = 0.0015};

class RandomSights {
public:
    double number(double most) { return std::uniform_real_distribution(-most, most)(numbers_); }

    /// A part that some pixels of the grid see, of random slopes; e: so wide in all axes.
    PatchSight next(double e) {
        const auto vector = [&](double most) {
            return glm::dvec3(number(most), number(most), number(most));
        };
        PatchSight sight{};
        sight.c = vector(0.3);
        sight.kp = vector(0.2);
        sight.kq = vector(0.2);
        sight.e = glm::dvec3(e);
        return sight;
    }

private:
    std::mt19937 numbers_{20261126};
};

bool has(const PatchOutline& outline, int col, int row) {
    const TileRect rect = outline.within(whole);
    if (row < rect.row || row >= rect.end_row) return false;
    const ColumnSpan span = outline.span(row, rect);
    return col >= span.col && col < span.end_col;
}

/// Outlines by `of` hold the pixels that see the places with |p|, |q| <= most.
template <class Sight>
void expect_held(double most, Sight of) {
    RandomSights sights;
    int seen = 0;
    for (int i = 0; i < 4000; ++i) {
        // Half a pixel is 0.0045 wide there.
        const PatchSight sight = sights.next(i % 2 == 0 ? 0.006 : 0.02);
        const UpwardRounding upward;
        const PatchOutline outline(of(sight), distance, grid);
        for (int k = 0; k < 20; ++k) {
            // A corner of the form now and then, and the nearest ray that is within its error.
            const double p =
                k % 4 == 0 ? std::copysign(most, sights.number(1.0)) : sights.number(most);
            const double q =
                k % 3 == 0 ? std::copysign(most, sights.number(1.0)) : sights.number(most);
            const glm::dvec3 at = sight.c + p * sight.kp + q * sight.kq;
            const double along = distance + at.z + sights.number(1.0) * sight.e.z;
            const auto col = static_cast<int>(std::lround((at.x / along - grid.u) / grid.pixel));
            const auto row = static_cast<int>(std::lround((grid.v - at.y / along) / grid.pixel));
            if (col < 0 || col >= side || row < 0 || row >= side) continue;
            const double a = along * (grid.u + col * grid.pixel);
            const double b = along * (grid.v - row * grid.pixel);
            ASSERT_LE(std::abs(a - at.x), sight.e.x);
            ASSERT_LE(std::abs(b - at.y), sight.e.y);
            EXPECT_TRUE(has(outline, col, row)) << i << ": " << col << ", " << row;
            ++seen;
        }
    }
    EXPECT_GT(seen, 5000);
}

TEST(PatchOutline, HoldsThePixelsThatSeeThePart) {
    expect_held(1.0, [](const PatchSight& sight) { return sight; });
}

TEST(PatchOutline, HoldsThoseThatSeeWhatAPartStandsFor) {
    expect_held(1.0 / form_growth, [](const PatchSight& sight) { return without_growth(sight); });
}

/// The pixels that an outline holds.
int count_of(const PatchSight& sight) {
    const UpwardRounding upward;
    const PatchOutline outline(sight, distance, grid);
    const TileRect rect = outline.within(whole);
    int count = 0;
    for (int row = rect.row; row < rect.end_row; ++row) {
        const ColumnSpan span = outline.span(row, rect);
        if (!span.empty()) count += span.end_col - span.col;
    }
    return count;
}

TEST(PatchOutline, IsNarrowAboutASliverThatIsSeenAslant) {
    PatchSight sight{};
    sight.c = {-0.01, 0.0, 0.0};
    sight.kp = {0.2, 0.2, 0.1};
    sight.kq = {0.02, -0.02, 0.0};
    sight.e = glm::dvec3(1e-4);
    // Its area is 16 (0.2 0.02) / 2 / (6 0.0015)^2, some 400 pixels of a square of 45 x 45.
    EXPECT_GT(count_of(sight), 350);
    EXPECT_LT(count_of(sight), 500);
}

TEST(PatchOutline, IsEverythingWhereNothingIsKnown) {
    RandomSights sights;
    PatchSight behind = sights.next(0.01);
    behind.kp.z = 7.0;  // reaches behind the eye
    EXPECT_EQ(count_of(behind), side * side);
    PatchSight unknown = sights.next(0.01);
    unknown.e.y = std::numeric_limits<double>::infinity();
    EXPECT_EQ(count_of(unknown), side * side);
}

}  // namespace
}  // namespace zeroset::test::patch_outline_test
