#include "engine/image/blend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

// Pixels mixed from finer ones.

namespace zeroset::test::blend_test {
namespace {

constexpr std::uint32_t black = 0xFF000000U;
constexpr std::uint32_t white = 0xFFFFFFFFU;

TEST(Blend, IsTheMeanOfTheLight) {
    Framebuffer picture(1, 1);
    Framebuffer finer(2, 2);
    for (int lit = 0; lit <= 4; ++lit) {
        for (int i = 0; i < 4; ++i)
            finer.color[static_cast<std::size_t>(i)] = i < lit ? white : black;
        blend_finer(finer, 2, {0, 0, 1, 1}, picture);
        // 255 sqrt(lit / 4), rounded
        constexpr std::uint32_t values[] = {0, 128, 180, 221, 255};
        EXPECT_EQ(picture.color[0], 0xFF000000U | values[lit] * 0x010101U) << lit;
    }
}

TEST(Blend, KeepsChannelsApartAndEvenColours) {
    Framebuffer picture(1, 1);
    Framebuffer finer(2, 2);
    finer.color = {0xFF00FF00U, 0xFF0000FFU, 0xFF00FF00U, 0xFF00FF00U};
    blend_finer(finer, 2, {0, 0, 1, 1}, picture);
    EXPECT_EQ(picture.color[0], 0xFF00DD80U);
    finer.color.assign(4, 0xFF123456U);
    blend_finer(finer, 2, {0, 0, 1, 1}, picture);
    EXPECT_EQ(picture.color[0], 0xFF123456U);
}

TEST(Blend, SaysHowMuchOfAPixelIsDrawn) {
    for (const int across : {2, 3, 4, 8}) {
        const auto rays = static_cast<std::size_t>(across * across);
        for (std::size_t hits = 0; hits <= rays; ++hits) {
            Framebuffer picture(1, 1);
            Framebuffer finer(across, across);
            for (std::size_t i = 0; i < rays; ++i) {
                finer.color[i] = i < hits ? white : black;
                finer.depth[i] = i < hits ? 1.0F : HUGE_VALF;
            }
            blend_finer(finer, across, {0, 0, 1, 1}, picture);
            const double part = static_cast<double>(hits) / static_cast<double>(rays);
            const double alpha = hits == 0 ? 255.0 : 255.0 * part;
            EXPECT_NEAR(picture.color[0] >> 24U, alpha, 0.5) << hits << " of " << rays;
            EXPECT_EQ(is_partly_drawn(picture.color[0]), hits % rays != 0) << hits;
        }
    }
}

TEST(Blend, FindsWhatWasDrawnBesideTheBackground) {
    constexpr std::uint32_t background = 0xFF3A322CU;
    for (const std::uint32_t color : {0xFFE08020U, 0xFF000000U, 0xFFFFFFFFU, background}) {
        for (std::size_t hits = 1; hits <= 3; ++hits) {
            Framebuffer picture(1, 1);
            Framebuffer finer(2, 2);
            finer.color.assign(4, background);
            for (std::size_t i = 0; i < hits; ++i) {
                finer.color[i] = color;
                finer.depth[i] = 1.0F;
            }
            blend_finer(finer, 2, {0, 0, 1, 1}, picture);
            const std::uint32_t drawn = without_background(picture.color[0], background);
            EXPECT_NEAR(drawn >> 24U, 63.75 * static_cast<double>(hits), 0.5);
            for (unsigned shift = 0; shift < 24; shift += 8) {
                const auto channel = [shift](std::uint32_t c) {
                    return static_cast<double>(c >> shift & 255U);
                };
                // Half a level of the mixed colour, as light, of which this is a part.
                const double mixed = channel(picture.color[0]);
                const double slack = (mixed + 0.25) * 4.0 / static_cast<double>(hits) + 0.5;
                EXPECT_NEAR(channel(drawn) * channel(drawn), channel(color) * channel(color),
                            slack + channel(color))
                    << hits;
            }
        }
    }
}

TEST(Blend, ChangesOnlyColoursOfTheRect) {
    Framebuffer picture(5, 4);
    picture.color.assign(20, black);
    picture.depth.assign(20, 3.0F);
    Framebuffer finer(8, 8);
    finer.color.assign(64, black);
    finer.depth.assign(64, 3.0F);
    finer.color[finer.index(3, 2)] = white;  // of the rect's pixel (1, 1)
    blend_finer(finer, 2, {2, 1, 3, 2}, picture);
    for (int row = 0; row < 4; ++row) {
        for (int col = 0; col < 5; ++col) {
            const std::size_t at = picture.index(col, row);
            EXPECT_EQ(picture.color[at] != black, col == 3 && row == 2) << col << ", " << row;
            EXPECT_EQ(picture.depth[at], 3.0F);
        }
    }
}

}  // namespace
}  // namespace zeroset::test::blend_test
