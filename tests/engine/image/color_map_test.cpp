#include "engine/image/color_map.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace zeroset::test::color_map_test {
namespace {

/// OKLab of what a screen shows (gamma 2 of the reflectance, as sRGB).
glm::dvec3 oklab(const Reflectance& color) {
    const auto light = [](float reflectance) {
        const double shown = std::sqrt(static_cast<double>(reflectance));
        return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
    };
    const double r = light(color[0]);
    const double g = light(color[1]);
    const double b = light(color[2]);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

constexpr std::size_t parts = 32;

std::vector<glm::dvec3> path_of(ColorMap map) {
    std::vector<glm::dvec3> path;
    for (std::size_t i = 0; i <= parts; ++i)
        path.push_back(oklab(color_at(map, static_cast<double>(i) / static_cast<double>(parts))));
    return path;
}

TEST(ColorMaps, GoInEvenSteps) {
    for (const ColorMap map : color_maps()) {
        const std::vector<glm::dvec3> path = path_of(map);
        double least = 1e9;
        double most = 0;
        double length = 0;
        for (std::size_t i = 0; i < parts; ++i) {
            const double step = glm::distance(path.at(i), path.at(i + 1));
            least = std::min(least, step);
            most = std::max(most, step);
            length += step;
        }
        EXPECT_LT(most, 1.7 * least) << name_of(map);
        EXPECT_GT(length, 0.6) << name_of(map);
    }
}

TEST(ColorMaps, TellNumbersApartByLightness) {
    for (const ColorMap map : {ColorMap::Aurora, ColorMap::Ember, ColorMap::Gray}) {
        const std::vector<glm::dvec3> path = path_of(map);
        for (std::size_t i = 0; i < parts; ++i)
            EXPECT_GT(path.at(i + 1).x - path.at(i).x, 0.01) << name_of(map) << " at " << i;
    }
    const std::vector<glm::dvec3> balance = path_of(ColorMap::Balance);
    for (std::size_t i = 0; i < parts / 2; ++i) {
        EXPECT_GT(balance.at(i + 1).x - balance.at(i).x, 0.01) << i;
        // Both sides are as light as each other, and lie opposite.
        EXPECT_NEAR(balance.at(i).x, balance.at(parts - i).x, 0.01) << i;
    }
    EXPECT_LT(balance.front().z, -0.1);  // blue
    EXPECT_GT(balance.back().y, 0.08);   // red
    const std::vector<glm::dvec3> cycle = path_of(ColorMap::Cycle);
    EXPECT_LT(glm::distance(cycle.front(), cycle.back()), 1e-4);
}

TEST(ColorMaps, EndAtTheirEnds) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const ColorMap map : color_maps()) {
        EXPECT_EQ(color_at(map, -0.5), color_at(map, 0.0));
        EXPECT_EQ(color_at(map, infinity), color_at(map, 1.0));
        const Reflectance none = color_at(map, nan);
        EXPECT_EQ(none[0], none[1]);
        EXPECT_EQ(none[1], none[2]);
        EXPECT_EQ(color_map_named(name_of(map)), map);
    }
    EXPECT_EQ(color_map_named("rainbow"), std::nullopt);
    EXPECT_EQ(shown_color_at(ColorMap::Gray, 1.0) >> 24U, 0xFFU);
}

}  // namespace
}  // namespace zeroset::test::color_map_test
