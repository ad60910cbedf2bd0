#include "engine/antialias/mixed_pixels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

// Pixels that look like those around them.

namespace zeroset::test::calm_pixels_test {
namespace {

constexpr int side = 20;
constexpr Tile tile{.col = 0, .row = 0, .cols = side, .rows = side};

/// A tile of hits of one surface, all of the same light.
class CalmPixels : public testing::Test {
protected:
    CalmPixels() : hits_(1) {
        for (int row = 0; row < side; ++row) {
            for (int col = 0; col < side; ++col)
                hits_[0].depth[static_cast<std::size_t>(row * tile_size + col)] = 1.0F;
        }
        hits_[0].any = true;
    }

    void light() {
        lit_.begin(hits_);
        for (int row = 0; row < side; ++row) {
            for (int channel = 0; channel < 3; ++channel)
                std::fill_n(layer().light_row(row, channel), tile_size, 0.3F);
            std::uint64_t& hits = layer().hit_rows[static_cast<std::size_t>(row)];
            hits = 0;
            for (int col = 0; col < side; ++col) {
                const float depth = hits_[0].depth[static_cast<std::size_t>(row * tile_size + col)];
                if (depth < std::numeric_limits<float>::infinity()) hits |= std::uint64_t{1} << col;
            }
        }
    }
    LitLayer& layer() { return lit_.layers().front(); }
    [[nodiscard]] bool is_calm(int col, int row) const {
        TileBits wanted{};
        wanted[static_cast<std::size_t>(row)] = std::uint64_t{1} << col;
        const TileBits calm = calm_pixels(tile, lit_.layers(), wanted);
        return (calm[static_cast<std::size_t>(row)] >> col & 1U) != 0;
    }

    std::vector<TileHits> hits_;
    LitTile lit_;
};

TEST_F(CalmPixels, AreThoseWithinTheTileWhereAllLooksTheSame) {
    light();
    for (int row = 0; row < side; ++row) {
        for (int col = 0; col < side; ++col) {
            const bool within = row > 0 && row + 1 < side && col > 0 && col + 1 < side;
            ASSERT_EQ(is_calm(col, row), within) << col << ", " << row;
        }
    }
}

TEST_F(CalmPixels, AreNotThoseBesideAPixelWithoutAHit) {
    hits_[0].depth[7 * tile_size + 9] = std::numeric_limits<float>::infinity();
    light();
    for (int row = 5; row < 10; ++row) {
        for (int col = 7; col < 12; ++col) {
            const bool beside = std::abs(row - 7) <= 1 && std::abs(col - 9) <= 1;
            ASSERT_EQ(is_calm(col, row), !beside) << col << ", " << row;
        }
    }
}

TEST_F(CalmPixels, AreNotThoseBesideAPixelOfAnotherColourInAnyChannel) {
    for (int channel = 0; channel < 3; ++channel) {
        light();
        layer().light_row(7, channel)[9] = 0.35F;
        for (int row = 5; row < 10; ++row) {
            for (int col = 7; col < 12; ++col) {
                const bool beside = std::abs(row - 7) <= 1 && std::abs(col - 9) <= 1;
                ASSERT_EQ(is_calm(col, row), !beside) << channel << ": " << col << ", " << row;
            }
        }
        // Light counts as the eye sees it: by the square root.
        layer().light_row(7, channel)[9] = 0.31F;
        ASSERT_TRUE(is_calm(8, 6));
    }
}

/// In a whole tile, whose last blocks end at its edges.
TEST(CalmPixelsOfAWholeTile, AreThoseWithoutOtherColoursAroundThemUpToTheEdges) {
    constexpr Tile whole{.col = 0, .row = 0, .cols = tile_size, .rows = tile_size};
    constexpr std::uint64_t all = ~std::uint64_t{0};
    std::vector<TileHits> hits(1);
    std::ranges::fill(hits[0].depth, 1.0F);
    hits[0].any = true;
    LitTile lit;
    lit.begin(hits);
    LitLayer& layer = lit.layers().front();
    layer.hit_rows.fill(all);
    std::ranges::fill(layer.light, 0.3F);
    TileBits odd{};
    const auto set_odd = [&](std::size_t col, std::size_t row) {
        layer.light_row(static_cast<int>(row), 1)[col] = 0.4F;
        odd[row] |= std::uint64_t{1} << col;
    };
    for (std::size_t i = 0; i < 9; ++i)
        set_odd(55 + i, 3 + 5 * i);
    set_odd(7, 20);
    set_odd(8, 30);
    set_odd(63, 63);
    TileBits wanted{};
    wanted.fill(all);
    const TileBits calm = calm_pixels(whole, lit.layers(), wanted);
    for (std::size_t row = 0; row < tile_size; ++row) {
        const bool is_inner = row > 0 && row + 1 < tile_size;
        const std::uint64_t near = is_inner ? odd[row - 1] | odd[row] | odd[row + 1] : all;
        const std::uint64_t beside = near | near << 1U | near >> 1U;
        const std::uint64_t edges = std::uint64_t{1} | std::uint64_t{1} << (tile_size - 1U);
        ASSERT_EQ(calm[row], ~(beside | edges)) << row;
    }
}

TEST_F(CalmPixels, AreNoneWhereASurfaceIsSeenThrough) {
    light();
    layer().cover.assign(std::size_t{tile_size} * tile_size, 0.5F);
    EXPECT_FALSE(is_calm(8, 6));
}

}  // namespace
}  // namespace zeroset::test::calm_pixels_test
