#include "engine/image/blend.hpp"

#include <gtest/gtest.h>

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

TEST(Blend, ChangesOnlyColoursOfTheRect) {
    Framebuffer picture(5, 4);
    picture.color.assign(20, black);
    picture.depth.assign(20, 3.0F);
    Framebuffer finer(8, 8);
    finer.color.assign(64, black);
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
