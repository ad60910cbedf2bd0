#include "engine/language/parse.hpp"
#include "pipeline/fit_view.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace zeroset::asked_box_test {
namespace {

std::optional<Box> box_for(std::string_view text) {
    const auto program = read_program(text);
    return program ? asked_box(*program) : std::nullopt;
}

TEST(AskedBox, IsThatOfTheCommand) {
    const auto box = box_for("ContourPlot3D[x^2 == z, {x, -1, 2}, {y, -3, 4}, {z, -5, 6}]");
    ASSERT_TRUE(box);
    EXPECT_EQ(box->lo, glm::dvec3(-1, -3, -5));
    EXPECT_EQ(box->hi, glm::dvec3(2, 4, 6));
    EXPECT_FALSE(box_for("x^2 = z, -1 < x < 1"));
    EXPECT_FALSE(box_for("ParametricPlot3D[{u, v, u v}, {u, 0, 1}, {v, 0, 1}]"));
}

TEST(AskedBox, HasTheHeightsOfAGraph) {
    const auto box = box_for("plot3d(x^2 + 3, x=-1..1, y=-1..1)");
    ASSERT_TRUE(box);
    EXPECT_LT(box->lo.z, 3.0);
    EXPECT_GT(box->lo.z, 2.8);
    EXPECT_GT(box->hi.z, 4.0);
    EXPECT_LT(box->hi.z, 4.2);
}

TEST(AskedBox, IsAtMostTwiceAsHighAsWide) {
    const auto box = box_for("splot x**2 - y**2");
    ASSERT_TRUE(box);
    EXPECT_EQ(box->hi.x - box->lo.x, 20.0);
    EXPECT_EQ(box->hi.z - box->lo.z, 40.0);
}

TEST(AskedBox, PassesOverAFewFarHeights) {
    const auto box = box_for("plot3d(1/(x^2 + y^2), x=-1..1, y=-1..1)");
    ASSERT_TRUE(box);
    EXPECT_LT(box->hi.z, 10.0);
}

TEST(AskedBox, IsOneForWhatHasNoHeights) {
    const auto box = box_for("plot3d(sqrt(-1 - x^2), x=-1..1, y=-1..1)");
    ASSERT_TRUE(box);
    EXPECT_EQ(box->hi.z, Box().hi.z);
}

}  // namespace
}  // namespace zeroset::asked_box_test
