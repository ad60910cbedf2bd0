#include "engine/scene/palette.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

// The colours of surfaces can be told apart, also by people without the cones for red or green.

namespace zeroset::test::palette_test {
namespace {

/// The sight of a dichromat, in linear RGB: rows of the matrix (Machado, Oliveira, Fernandes 2009).
struct Vision {
    std::string name;
    glm::dmat3 rows;
};

const Vision visions[] = {
    {"normal", glm::dmat3(1.0)},
    {"protanopia",
     {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998}},
    {"deuteranopia",
     {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881}}};

/// CIELAB of a display colour (gamma 2 of `reflectance`, shown as sRGB) as seen.
glm::dvec3 seen(const float (&reflectance)[3], const Vision& vision) {
    glm::dvec3 light;
    for (int i = 0; i < 3; ++i) {
        const double display = std::sqrt(static_cast<double>(reflectance[i]));
        light[i] = display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4);
    }
    light = glm::clamp(light * vision.rows, 0.0, 1.0);
    const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = root(glm::dot(light, {0.4124, 0.3576, 0.1805}) / 0.9505);
    const double y = root(glm::dot(light, {0.2126, 0.7152, 0.0722}));
    const double z = root(glm::dot(light, {0.0193, 0.1192, 0.9505}) / 1.089);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

TEST(Palette, CanBeToldApart) {
    constexpr double fronts_apart = 18.0;  // CIE 1976; 2.3 is just noticeable side by side
    constexpr double sides_apart = 34.0;
    ASSERT_GE(palette().size(), 8U);
    for (const Vision& vision : visions) {
        for (std::size_t a = 0; a < palette().size(); ++a) {
            const glm::dvec3 front = seen(palette()[a].front, vision);
            EXPECT_GT(glm::distance(front, seen(palette()[a].back, vision)), sides_apart)
                << vision.name << ": " << a;
            for (std::size_t b = 0; b < a; ++b) {
                EXPECT_GT(glm::distance(front, seen(palette()[b].front, vision)), fronts_apart)
                    << vision.name << ": " << a << ", " << b;
            }
        }
    }
}

TEST(Palette, ShowsTheFrontInASwatch) {
    EXPECT_EQ(swatch_color(0), 0xFFD89051U);  // blue: 0x51, 0x90, 0xD8
    EXPECT_EQ(swatch_color(palette().size()), swatch_color(0));
    EXPECT_NE(swatch_color(1), swatch_color(0));
    EXPECT_EQ(&colors_of(palette().size() + 2), &palette()[2]);
}

}  // namespace
}  // namespace zeroset::test::palette_test
