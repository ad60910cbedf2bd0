#include "engine/export/codecs/film_palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset::test::film_palette_test {
namespace {

constexpr std::uint8_t transparent = 255;

TEST(FilmPalette, FewColoursAreKept) {
    const std::vector<std::uint32_t> pixels{0xFF0000FFU, 0xFF00FF00U, 0xFFFF0000U, 0xFF808080U};
    const VideoFrame frame{.width = 2, .height = 2, .pixels = pixels};
    ColorCounts counts;
    counts.add(frame);
    FilmPalette palette = counts.palette(255);
    std::ranges::sort(palette);
    EXPECT_EQ(palette, (FilmPalette{0x0000FF, 0x00FF00, 0x808080, 0xFF0000}));
    const auto numbers = dithered(frame, palette, transparent);
    EXPECT_EQ(palette[numbers[0]], 0xFF0000U) << "the lowest byte is red";
    EXPECT_EQ(palette[numbers[2]], 0x0000FFU);
}

TEST(FilmPalette, DitheringKeepsTheMean) {
    constexpr int side = 64;
    std::vector<std::uint32_t> pixels;
    double sum = 0.0;
    for (int i = 0; i < side * side; ++i) {
        const auto gray = static_cast<std::uint32_t>(i % side * 2 + 60);
        pixels.push_back(0xFF000000U | gray * 0x010101U);
        sum += gray;
    }
    const VideoFrame frame{.width = side, .height = side, .pixels = pixels};
    const FilmPalette palette{0x303030, 0xD0D0D0};
    double shown = 0.0;
    for (const std::uint8_t number : dithered(frame, palette, transparent))
        shown += palette[number] & 0xFFU;
    EXPECT_NEAR(shown / (side * side), sum / (side * side), 1.0);
}

TEST(FilmPalette, AGradientIsSeenWithinItsSteps) {
    constexpr int side = 128;
    std::vector<std::uint32_t> pixels;
    for (int i = 0; i < side * side; ++i) {
        const auto red = static_cast<std::uint32_t>(2 * (i % side));
        const auto blue = static_cast<std::uint32_t>(2 * (i / side));
        pixels.push_back(0xFF000000U | red | blue << 16U);
    }
    ColorCounts counts;
    counts.add({.width = side, .height = side, .pixels = pixels});
    const FilmPalette palette = counts.palette(255);
    EXPECT_EQ(palette.size(), 255U);
    for (const std::uint32_t pixel : pixels) {
        double least = 1e9;
        for (const std::uint32_t color : palette) {
            const double red = static_cast<double>(color >> 16U) - (pixel & 0xFFU);
            const double blue = static_cast<double>(color & 0xFFU) - (pixel >> 16U & 0xFFU);
            least = std::min(least, std::hypot(red, blue));
        }
        ASSERT_LE(least, 20.0);
    }
}

TEST(FilmPalette, TransparentPixelsHaveTheirOwnNumber) {
    const std::vector<std::uint32_t> pixels{0x00FFFFFFU, 0xFF102030U};
    const VideoFrame frame{.width = 2, .height = 1, .alpha = true, .pixels = pixels};
    ColorCounts counts;
    counts.add(frame);
    const FilmPalette palette = counts.palette(255);
    EXPECT_EQ(palette, (FilmPalette{0x302010}));
    EXPECT_EQ(dithered(frame, palette, transparent), (std::vector<std::uint8_t>{255, 0}));
}

}  // namespace
}  // namespace zeroset::test::film_palette_test
