#include "engine/antialias/mixed_pixels.hpp"
#include "engine/antialias/seen_sheet.hpp"
#include "tests/support/plane_tile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Which pixels show the edge of a shadow on one sheet.

namespace zeroset::test::light_edges_test {
namespace {

/// Planes z = rise x + height below an eye, in a tile of its own.
class LightEdges : public PlaneTile {
protected:
    LightEdges() : PlaneTile(0.02) {}

    /// The distance of the plane along the ray of a pixel.
    [[nodiscard]] double distance(int col, int row, double rise, double height) const {
        const glm::dvec3 direction = view_.direction(pixel_centre(col, row), frame_.image);
        const double along = (height - 4.0) / (direction.z - rise * direction.x);
        return along * glm::length(direction);
    }
    [[nodiscard]] SeenSheet sheet(int col, int row, double rise) const {
        return {rays_, static_cast<double>(col), static_cast<double>(row),
                distance(col, row, rise, 0.0), glm::dvec3(-rise, 0.0, 1.0)};
    }
    /// A plane up to a column, and another one from there on, which is dark.
    [[nodiscard]] std::size_t edges_at(int first_dark, double height) {
        lit_.begin(hits_);
        LitLayer& layer = lit_.layers().front();
        for (int row = 0; row < side; ++row) {
            for (int col = 0; col < side; ++col)
                put(layer, col, row, col < first_dark ? 0.0 : height, col >= first_dark);
        }
        std::vector<MixedPixel> mixed;
        add_light_edges(tile, rays_, lit_.layers(), hits_, false, mixed);
        return mixed.size();
    }

    LitTile lit_;

private:
    void put(LitLayer& layer, int col, int row, double height, bool is_dark) {
        const auto at = static_cast<std::size_t>(row * tile_size + col);
        hits_[0].depth[at] = static_cast<float>(distance(col, row, 0.0, height));
        hits_[0].gradient[2][at] = 1.0F;
        if (is_dark) layer.dark_rows[static_cast<std::size_t>(row)] |= std::uint64_t{1} << col;
        layer.hit_rows[static_cast<std::size_t>(row)] |= std::uint64_t{1} << col;
        for (int channel = 0; channel < 3; ++channel)
            layer.light_row(row, channel)[col] = is_dark ? 0.1F : 0.5F;
    }
};

TEST_F(LightEdges, AreOnBothSidesOfAShadowsEdge) { EXPECT_EQ(edges_at(7, 0.0), 2U * side); }

TEST_F(LightEdges, AreNotBetweenSheetsOneBehindTheOther) {
    EXPECT_EQ(edges_at(7, -0.1), 0U);  // eighty pixels behind
    EXPECT_EQ(edges_at(7, 0.1), 0U);
}

TEST_F(LightEdges, SheetsReachTheirOwnHitsBeside) {
    for (const double rise : {0.0, 0.5, -1.0, 5.0, -15.0}) {
        for (int col = 1; col < side; ++col) {
            const double apart =
                std::abs(distance(col, 5, rise, 0.0) - distance(col - 1, 5, rise, 0.0));
            EXPECT_TRUE(sheet(col, 5, rise).may_be_apart(apart)) << rise << " at " << col;
            const double width = rays_.pixel() * distance(col, 5, rise, 0.0);
            const double most = 4.001 * width * std::sqrt(1.0 + rise * rise) * 1.2;
            EXPECT_FALSE(sheet(col, 5, rise).may_be_apart(most)) << rise << " at " << col;
        }
    }
}

TEST_F(LightEdges, SheetsShowTheEyeTheSideThatTheyShowTheLight) {
    EXPECT_TRUE(sheet(3, 5, 0.5).shows_side_to({0, 0, 1}));
    EXPECT_TRUE(sheet(3, 5, 0.5).shows_side_to({1, 0, 0.6}));
    EXPECT_FALSE(sheet(3, 5, 0.5).shows_side_to({1, 0, 0.4}));
    EXPECT_FALSE(sheet(3, 5, 0.5).shows_side_to({0, 0, -1}));
}

}  // namespace
}  // namespace zeroset::test::light_edges_test
