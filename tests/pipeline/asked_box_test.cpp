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

/// The box of a text in which the slider a is at `a`.
std::optional<Box> graph_box_for(std::string_view text, double a = 1.0) {
    const auto program = read_program(text);
    Document document;
    document.parameters["a"] = {.value = a};
    return program ? graph_box(*program, document) : std::nullopt;
}

TEST(GraphBox, IsAsHighAsTheGraph) {
    const auto box = graph_box_for("z = a sin(x) cos(y)", 1.5);
    ASSERT_TRUE(box);
    EXPECT_EQ(box->lo.x, -2.0);
    EXPECT_NEAR(box->lo.z, -1.65, 0.06);
    EXPECT_NEAR(box->hi.z, 1.65, 0.06);
    EXPECT_TRUE(graph_box_for("x^2/4 = z"));
    EXPECT_TRUE(graph_box_for("f(x, y) = x^2/4"));
}

TEST(GraphBox, IsNoHigherThanWideAndHoldsMostOfTheGraph) {
    const auto bowl = graph_box_for("z = x^2 + y^2");
    ASSERT_TRUE(bowl);
    EXPECT_NEAR(bowl->lo.z, -0.1, 0.05);
    EXPECT_NEAR(bowl->hi.z, 4.0, 0.1);
    const auto saddle = graph_box_for("z = x^2 - y^2");
    ASSERT_TRUE(saddle);
    EXPECT_NEAR(saddle->lo.z, -saddle->hi.z, 0.3);
}

TEST(GraphBox, IsNoPlate) {
    const auto box = graph_box_for("z = 0.001 x + 7");
    ASSERT_TRUE(box);
    EXPECT_NEAR(box->centre().z, 7.0, 0.1);
    EXPECT_GE(box->hi.z - box->lo.z, 1.0);
}

TEST(GraphBox, IsOfGraphsAlone) {
    for (const char* text : {"x^2 + y^2 + z^2 = 1", "z = x z", "x = y^2", "z = x; x^2 + y^2 = 1",
                             "z = sqrt(-1 - x^2)"})
        EXPECT_FALSE(graph_box_for(text)) << text;
}

}  // namespace
}  // namespace zeroset::asked_box_test
