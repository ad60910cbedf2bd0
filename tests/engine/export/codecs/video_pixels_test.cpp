#include "engine/export/codecs/video_pixels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace zeroset::test::video_pixels_test {
namespace {

constexpr std::uint32_t rgb(unsigned red, unsigned green, unsigned blue, unsigned alpha = 255) {
    return red | green << 8U | blue << 16U | alpha << 24U;
}

/// Luma, blue chroma, red chroma and alpha of a frame of one colour.
std::array<int, 4> planes_of(std::uint32_t color, const VideoLayout& layout) {
    const std::vector<std::uint32_t> pixels(16, color);
    std::array<std::vector<std::uint8_t>, 4> room;
    std::array<VideoPlane, 4> planes;
    for (std::size_t i = 0; i < 4; ++i) {
        room[i].resize(64);
        planes[i] = {.data = room[i].data(), .row_bytes = layout.bits == 8 ? 4 : 8};
    }
    write_video_planes({.width = 4, .height = 4, .alpha = true, .pixels = pixels}, layout, planes);
    std::array<int, 4> numbers{};
    for (std::size_t i = 0; i < 4; ++i)
        numbers[i] = layout.bits == 8 ? room[i][1] : room[i][2] + 256 * room[i][3];
    return numbers;
}

using Numbers = std::array<int, 4>;

// The corners of BT.709's cube of colours, as its tables have them.
TEST(VideoPixels, HasTheNumbersOfBt709) {
    for (const bool quartered : {true, false}) {
        const VideoLayout layout{.bits = 8, .quartered = quartered};
        EXPECT_EQ(planes_of(rgb(0, 0, 0), layout), (Numbers{16, 128, 128, 255}));
        EXPECT_EQ(planes_of(rgb(255, 255, 255), layout), (Numbers{235, 128, 128, 255}));
        EXPECT_EQ(planes_of(rgb(255, 0, 0), layout), (Numbers{63, 102, 240, 255}));
        EXPECT_EQ(planes_of(rgb(0, 255, 0), layout), (Numbers{173, 42, 26, 255}));
        EXPECT_EQ(planes_of(rgb(0, 0, 255), layout), (Numbers{32, 240, 118, 255}));
    }
    const VideoLayout ten{.bits = 10, .quartered = false};
    EXPECT_EQ(planes_of(rgb(255, 255, 255, 0), ten), (Numbers{940, 512, 512, 0}));
    EXPECT_EQ(planes_of(rgb(0, 0, 0), ten), (Numbers{64, 512, 512, 1023}));
}

TEST(VideoPixels, IsWithinHalfAStepOfTheFormula) {
    std::mt19937 random(5);
    for (int i = 0; i < 5000; ++i) {
        const double red = static_cast<double>(random() % 256);
        const double green = static_cast<double>(random() % 256);
        const double blue = static_cast<double>(random() % 256);
        const double luma = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
        const Numbers got = planes_of(rgb(static_cast<unsigned>(red), static_cast<unsigned>(green),
                                          static_cast<unsigned>(blue)),
                                      {.bits = 8, .quartered = false});
        EXPECT_NEAR(got[0], 16 + 219 * luma / 255, 0.51);
        EXPECT_NEAR(got[1], 128 + 224 * (blue - luma) / 1.8556 / 255, 0.51);
        EXPECT_NEAR(got[2], 128 + 224 * (red - luma) / 1.5748 / 255, 0.51);
    }
}

TEST(VideoPixels, TransparentPixelsLendNoChroma) {
    // Red beside transparent black: the chroma of the square is that of red.
    const std::vector<std::uint32_t> pixels{rgb(255, 0, 0), 0, rgb(255, 0, 0), 0};
    std::array<std::array<std::uint8_t, 4>, 4> room{};
    std::array<VideoPlane, 4> planes;
    for (std::size_t i = 0; i < 4; ++i)
        planes[i] = {.data = room[i].data(), .row_bytes = 2};
    write_video_planes({.width = 2, .height = 2, .alpha = true, .pixels = pixels}, {}, planes);
    EXPECT_EQ(room[1][0], 102);
    EXPECT_EQ(room[2][0], 240);
    EXPECT_EQ(room[3][0], 255);
    EXPECT_EQ(room[3][1], 0);
}

}  // namespace
}  // namespace zeroset::test::video_pixels_test
