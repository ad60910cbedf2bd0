#include "engine/image/blend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

// Pixels mixed from finer ones.

namespace zeroset::test {
namespace {

constexpr std::uint32_t black = 0xFF000000U;
constexpr std::uint32_t white = 0xFFFFFFFFU;

TEST(Blend, IsTheMeanOfTheLight) {
    Framebuffer picture(1, 1);
    Framebuffer finer(2, 2);
    for (int lit = 0; lit <= 4; ++lit) {
        picture.color[0] = black;
        for (int i = 0; i < 4; ++i)
            finer.color[static_cast<std::size_t>(i)] = i < lit ? white : black;
        blend_finer(finer, {0, 0, 1, 1}, picture);
        // 255 sqrt(lit / 5), rounded
        constexpr std::uint32_t values[] = {0, 114, 161, 198, 228};
        EXPECT_EQ(picture.color[0], 0xFF000000U | values[lit] * 0x010101U) << lit;
    }
}

TEST(Blend, KeepsChannelsApartAndEvenColours) {
    Framebuffer picture(1, 1);
    Framebuffer finer(2, 2);
    picture.color[0] = 0xFF0000FFU;
    finer.color.assign(4, 0xFF00FF00U);
    blend_finer(finer, {0, 0, 1, 1}, picture);
    EXPECT_EQ(picture.color[0], 0xFF00E472U);
    picture.color[0] = 0xFF123456U;
    finer.color.assign(4, 0xFF123456U);
    blend_finer(finer, {0, 0, 1, 1}, picture);
    EXPECT_EQ(picture.color[0], 0xFF123456U);
}

TEST(Blend, SaysHowMuchOfAPixelIsDrawn) {
    Framebuffer picture(1, 1);
    Framebuffer finer(2, 2);
    for (std::size_t hits = 0; hits <= 5; ++hits) {
        // The first is the pixel's own ray.
        picture.color[0] = hits > 0 ? white : black;
        picture.depth[0] = hits > 0 ? 1.0F : HUGE_VALF;
        for (std::size_t i = 0; i < 4; ++i) {
            finer.color[i] = i + 1 < hits ? white : black;
            finer.depth[i] = i + 1 < hits ? 1.0F : HUGE_VALF;
        }
        blend_finer(finer, {0, 0, 1, 1}, picture);
        constexpr std::uint32_t alphas[] = {255, 51, 102, 153, 204, 255};
        EXPECT_EQ(picture.color[0] >> 24U, alphas[hits]) << hits;
        EXPECT_EQ(is_partly_drawn(picture.color[0]), hits % 5 != 0) << hits;
    }
}

TEST(Blend, FindsWhatWasDrawnBesideTheBackground) {
    constexpr std::uint32_t background = 0xFF3A322CU;
    for (const std::uint32_t color : {0xFFE08020U, 0xFF000000U, 0xFFFFFFFFU, background}) {
        for (std::size_t hits = 1; hits <= 4; ++hits) {
            Framebuffer picture(1, 1);
            Framebuffer finer(2, 2);
            picture.color[0] = background;
            finer.color.assign(4, background);
            for (std::size_t i = 0; i < hits; ++i) {
                finer.color[i] = color;
                finer.depth[i] = 1.0F;
            }
            blend_finer(finer, {0, 0, 1, 1}, picture);
            const std::uint32_t drawn = without_background(picture.color[0], background);
            EXPECT_EQ(drawn >> 24U, 51U * hits);
            for (unsigned shift = 0; shift < 24; shift += 8) {
                const auto channel = [shift](std::uint32_t c) {
                    return static_cast<double>(c >> shift & 255U);
                };
                // Half a level of the mixed colour, as light, of which this is a part.
                const double mixed = channel(picture.color[0]);
                const double slack = (mixed + 0.25) * 5.0 / static_cast<double>(hits) + 0.5;
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
    blend_finer(finer, {2, 1, 3, 2}, picture);
    for (int row = 0; row < 4; ++row) {
        for (int col = 0; col < 5; ++col) {
            const std::size_t at = picture.index(col, row);
            EXPECT_EQ(picture.color[at] != black, col == 3 && row == 2) << col << ", " << row;
            EXPECT_EQ(picture.depth[at], 3.0F);
        }
    }
}

}  // namespace
}  // namespace zeroset::test
