#include "engine/annotate/paint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

// Lines with smooth edges, by what they cover.

namespace zeroset::test::paint_test {
namespace {

constexpr std::uint32_t black = 0xFF000000U;
constexpr std::uint32_t white = 0xFFFFFFFFU;

Framebuffer black_picture() {
    Framebuffer picture(40, 30);
    std::ranges::fill(picture.color, black);
    return picture;
}

/// Sum of all that is painted, in pixels.
double area(const Framebuffer& picture) {
    double sum = 0.0;
    for (const std::uint32_t color : picture.color)
        sum += (color & 0xFFU) / 255.0;
    return sum;
}

TEST(Blended, MixesByOpacityAndCoverage) {
    EXPECT_EQ(blended(black, white, 1.0), white);
    EXPECT_EQ(blended(0xFF123456U, white, 0.0), 0xFF123456U);
    EXPECT_EQ(blended(black, 0x80FFFFFFU, 1.0), 0xFF808080U);
    EXPECT_EQ(blended(0xFF0000FFU, 0xFF00FF00U, 0.5) & 0xFFU, 128U);
}

TEST(Line, CoversItsLengthTimesItsWidth) {
    for (const glm::dvec2 to : {glm::dvec2(35, 15), {20, 27}, {31, 4}, {5, 3}}) {
        for (const double width : {1.0, 2.0, 3.5}) {
            Framebuffer picture = black_picture();
            const glm::dvec2 from(20, 15);
            paint_line(picture, from, to, width, white);
            const double expected = width * glm::distance(from, to);
            EXPECT_NEAR(area(picture), expected, 0.13 * expected) << to.x << "," << to.y;
        }
    }
}

TEST(Line, IsSharpOnPixelCentres) {
    Framebuffer picture = black_picture();
    paint_line(picture, {5, 10.5}, {15, 10.5}, 1.0, white);
    for (int col = 0; col < picture.width; ++col) {
        const bool inside = col >= 5 && col < 15;
        EXPECT_EQ(picture.color[picture.index(col, 10)], inside ? white : black) << col;
        EXPECT_EQ(picture.color[picture.index(col, 9)], black);
        EXPECT_EQ(picture.color[picture.index(col, 11)], black);
    }
}

TEST(Line, GoesOnInAnotherWithoutASeam) {
    Framebuffer whole = black_picture();
    Framebuffer halves = black_picture();
    const glm::dvec2 from(3, 4);
    const glm::dvec2 to(33, 21);
    const glm::dvec2 middle = glm::mix(from, to, 0.37);
    paint_line(whole, from, to, 1.5, 0x80FFFFFFU);
    paint_line(halves, from, middle, 1.5, 0x80FFFFFFU);
    paint_line(halves, middle, to, 1.5, 0x80FFFFFFU);
    EXPECT_EQ(whole.color, halves.color);
}

TEST(Line, MayLeaveThePicture) {
    Framebuffer picture = black_picture();
    paint_line(picture, {-1e6, 10.5}, {1e6, 10.5}, 1.0, white);
    paint_line(picture, {50, 50}, {60, 70}, 3.0, white);
    paint_line(picture, {7, 7}, {7, 7}, 3.0, white);
    EXPECT_NEAR(area(picture), picture.width, 1e-9);
}

}  // namespace
}  // namespace zeroset::test::paint_test
