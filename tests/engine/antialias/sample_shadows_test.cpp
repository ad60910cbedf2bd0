#include "engine/antialias/seen_sheet.hpp"
#include "engine/light/shade.hpp"
#include "tests/support/plane_tile.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

// The shadow at a sample, as the pixels around it tell.

namespace zeroset::test::sample_shadows_test {
namespace {

constexpr float distance = 4.0F;

/// A sheet that faces the eye, in a tile of its own; pixels of the columns from `shadow` on are
/// dark.
class SampleShadows : public PlaneTile {
protected:
    SampleShadows() : PlaneTile(0.5) {
        for (int row = 0; row < side; ++row) {
            for (int col = 0; col < side; ++col)
                put(col, row, distance, {0.0F, 0.0F, 2.0F});
        }
    }

    void put(int col, int row, float depth, const std::array<float, 3>& gradient) {
        const auto at = static_cast<std::size_t>(row * tile_size + col);
        hits_[0].depth[at] = depth;
        for (std::size_t axis = 0; axis < 3; ++axis)
            hits_[0].gradient[axis][at] = gradient[axis];
    }
    [[nodiscard]] SampleShadow shadow_at(int col, int row, int first_dark,
                                         const std::array<float, 3>& gradient = {0, 0, 1},
                                         float depth = distance) {
        lit_.begin(hits_);
        LitLayer& layer = lit_.layers().front();
        for (int r = 0; r < side; ++r) {
            layer.hit_rows[static_cast<std::size_t>(r)] = 0;
            for (int c = 0; c < side; ++c) {
                const auto at = static_cast<std::size_t>(r * tile_size + c);
                const std::uint64_t bit = std::uint64_t{1} << c;
                if (c >= first_dark) layer.dark_rows[static_cast<std::size_t>(r)] |= bit;
                if (hits_[0].depth[at] < std::numeric_limits<float>::infinity())
                    layer.hit_rows[static_cast<std::size_t>(r)] |= bit;
            }
        }
        return shadow_around(layer, tile, rays_, key_light(view_),
                             {.pixel = static_cast<std::uint16_t>(row * tile_size + col),
                              .surface = 0,
                              .certificate = Certificate::Certified,
                              .area = 0.5F,
                              .col = static_cast<float>(col) + 0.25F,
                              .row = static_cast<float>(row),
                              .distance = depth,
                              .gradient = gradient});
    }

    LitTile lit_;
};

TEST_F(SampleShadows, AreKnownWhereAllAroundAgree) {
    for (int col = 0; col < side; ++col) {
        const SampleShadow expected = col < 7    ? SampleShadow::Lit
                                      : col <= 8 ? SampleShadow::Unknown
                                                 : SampleShadow::Dark;
        ASSERT_EQ(shadow_at(col, 5, 8), expected) << col;
    }
}

TEST_F(SampleShadows, AreUnknownOnAnotherSheet) {
    EXPECT_EQ(shadow_at(3, 5, 8, {0, 0, -1}), SampleShadow::Unknown);
    EXPECT_EQ(shadow_at(3, 5, 8, {1, 0, 0.5}), SampleShadow::Unknown);
    EXPECT_EQ(shadow_at(3, 5, 8, {0, 0, 1}, distance + 1.0F), SampleShadow::Unknown);
    EXPECT_EQ(shadow_at(3, 5, 8, {0, 0, 0}), SampleShadow::Unknown);
    EXPECT_EQ(shadow_at(3, 5, 8, {NAN, 0, 1}), SampleShadow::Unknown);
}

TEST_F(SampleShadows, OfOneSheetDoNotCountThoseOfAnother) {
    // A column of another sheet lies in the shadow.
    for (int row = 0; row < side; ++row)
        put(8, row, 2.0F, {0, 1, 0});
    EXPECT_EQ(shadow_at(7, 5, 8), SampleShadow::Lit);
}

TEST_F(SampleShadows, AreUnknownWhereTheLightIsBehind) {
    const std::array<float, 3> away{1.0F, -1.0F, 0.8F};
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col)
            put(col, row, distance, away);
    }
    EXPECT_EQ(shadow_at(3, 5, 8, away), SampleShadow::Unknown);
    EXPECT_EQ(shadow_at(3, 5, 8, {-1.0F, 1.0F, 0.8F}), SampleShadow::Unknown);  // another sheet
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col)
            put(col, row, distance, {-1.0F, 1.0F, 0.8F});
    }
    EXPECT_EQ(shadow_at(3, 5, 8, {-1.0F, 1.0F, 0.8F}), SampleShadow::Lit);
}

TEST_F(SampleShadows, AreNotToldByASingleHit) {
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col) {
            if (col != 3 || row != 5)
                put(col, row, std::numeric_limits<float>::infinity(), {0, 0, 1});
        }
    }
    EXPECT_EQ(shadow_at(3, 5, 8), SampleShadow::Unknown);
}

}  // namespace
}  // namespace zeroset::test::sample_shadows_test
