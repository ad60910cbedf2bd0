#include "pipeline/contour_step.hpp"

#include "engine/interpret/interpret.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Steps between contour lines that are found by themselves.

namespace zeroset::test::contour_step_test {
namespace {

double step_of(const std::string& surface, const std::string& number) {
    const Scene scene = scene_of(surface, Box::cube(2));
    const auto expr = parse(number);
    EXPECT_TRUE(expr) << number;
    return contour_step(scene, interpret_points(*expr));
}

TEST(ContourStep, MakesSomeTenLinesOnTheSurface) {
    // The number's range on the surface, from closed forms.
    const std::vector<std::pair<std::string, double>> ranges{
        {"x", 2.0}, {"100 x", 200.0}, {"x^2 + y^2", 1.0}, {"0.001 z", 0.002}};
    for (const auto& [number, range] : ranges) {
        const double lines = range / step_of("x^2 + y^2 + z^2 = 1", number);
        EXPECT_GE(lines, 5.0) << number;
        EXPECT_LE(lines, 20.0) << number;
    }
}

TEST(ContourStep, IsOneTwoOrFiveTimesAPowerOfTen) {
    for (const char* const number : {"x", "x y + 3", "exp(3 x)", "0.07 x^3"}) {
        const double step = step_of("z = 0.3 x", number);
        const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
        EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 ||
                    std::abs(digit - 5) < 1e-9)
            << number << ": " << step;
    }
}

TEST(ContourStep, IsThatOfTheBoxWhereNoSurfaceIsFound) {
    EXPECT_EQ(step_of("x^2 + y^2 + z^2 = -1", "x"), 0.5);
    EXPECT_EQ(step_of("z = 0", "sqrt(-1 - x^2)"), 1.0) << "there is no value";
}

}  // namespace
}  // namespace zeroset::test::contour_step_test
