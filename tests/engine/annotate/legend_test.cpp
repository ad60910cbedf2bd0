#include "engine/annotate/legend.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

// The legend as shapes: its words, where it stands, and when there is no room for it.

namespace zeroset::test::legend_test {
namespace {

/// Letters that are all half an em wide.
CardStyle plain_style() {
    return {.unit = 14.0, .em = 10.0, .width = [](std::string_view words, double em) {
                return 0.5 * em * static_cast<double>(words.size());
            }};
}

Legend depth_legend(const ValueRange& range) {
    Coloring coloring;
    coloring.by = ColorBy::Depth;
    coloring.range = range;
    return legend_of(coloring, "");
}

std::vector<std::string> words_of(const Shapes& shapes) {
    std::vector<std::string> words;
    for (const Shape& shape : shapes) {
        if (const Text* text = std::get_if<Text>(&shape)) words.push_back(text->words);
    }
    return words;
}

template <class Kind>
std::ptrdiff_t count_of(const Shapes& shapes) {
    return std::ranges::count_if(
        shapes, [](const Shape& shape) { return std::holds_alternative<Kind>(shape); });
}

TEST(LegendOf, SaysWhatTheColoursTell) {
    Coloring coloring;
    coloring.by = ColorBy::Height;
    coloring.up = {0, -1, 0};
    coloring.range = ValueRange{-2, 3};
    EXPECT_EQ(legend_of(coloring, "").title,
              "height: \xE2\x88\x92"
              "y");
    EXPECT_EQ(legend_of(coloring, "").range, coloring.range);
    coloring.by = ColorBy::Normal;
    EXPECT_EQ(legend_of(coloring, "").title, "normal");
    EXPECT_FALSE(legend_of(coloring, "").range);
    coloring.by = ColorBy::Expression;
    EXPECT_EQ(legend_of(coloring, "x y").title, "x y");
}

TEST(LegendShapes, AreACardInTheCornerWithTheNumbersOfTheRange) {
    const Legend legend = depth_legend({-1.25, 7.5});
    const Shapes shapes = legend_shapes({&legend}, {490, 390}, {480, 380}, plain_style());
    EXPECT_EQ(words_of(shapes),
              (std::vector<std::string>{"distance from the eye", "-1.25", "7.5", "3.125"}));
    const auto& card = std::get<RoundedRectangle>(shapes.at(0));
    EXPECT_EQ(card.hi, glm::dvec2(490, 390));
    EXPECT_NEAR(card.hi.x - card.lo.x, 16.4 * 14.0, 1e-9);
    for (const Shape& shape : shapes) {
        if (const MapBar* bar = std::get_if<MapBar>(&shape)) {
            EXPECT_GT(bar->lo.x, card.lo.x);
            EXPECT_LT(bar->hi.x, card.hi.x);
            EXPECT_LT(bar->hi.y, card.hi.y);
        }
    }
    EXPECT_EQ(count_of<MapBar>(shapes), 1);
}

TEST(LegendShapes, NeverSayMinusZero) {
    const Legend legend = depth_legend({-0.0, 2.0});
    const Shapes shapes = legend_shapes({&legend}, {490, 390}, {480, 380}, plain_style());
    EXPECT_EQ(words_of(shapes).at(1), "0");
}

TEST(LegendShapes, LeaveOutTheMiddleNumberAndTheTitlesEndWhereThereIsNoRoom) {
    Legend legend = depth_legend({-1.234e-10, -1.233e-10});
    legend.title = "sin(x) sin(y) sin(z) cos(x) \xCE\xB1\xCE\xB2\xCE\xB3";
    const double room = 16.4 * 14.0 / 0.62;
    // So narrow that the numbers would touch.
    const Shapes shapes = legend_shapes({&legend}, {room, 390}, {0.7 * room, 380}, plain_style());
    const std::vector<std::string> words = words_of(shapes);
    EXPECT_EQ(words.size(), 3U);
    EXPECT_TRUE(words.at(0).ends_with("\xE2\x80\xA6")) << words.at(0);
    const auto& card = std::get<RoundedRectangle>(shapes.at(0));
    EXPECT_LE(plain_style().width(words.at(0), 10.0), card.hi.x - card.lo.x - 1.4 * 14.0);
}

TEST(LegendShapes, AreNoneWhereThereIsNothingToSayOrNoRoom) {
    const Legend legend = depth_legend({0, 1});
    EXPECT_TRUE(legend_shapes({}, {490, 390}, {480, 380}, plain_style()).empty());
    EXPECT_TRUE(legend_shapes({&legend}, {190, 390}, {180, 380}, plain_style()).empty());
    EXPECT_TRUE(legend_shapes({&legend}, {490, 120}, {480, 110}, plain_style()).empty());
}

TEST(LegendShapes, ExplainHowPixelsAreMarked) {
    const auto words = [](const CornerLegend& legend) {
        return words_of(legend_shapes(legend, {490, 390}, {480, 380}, plain_style()));
    };
    EXPECT_EQ(words({.undecided = true}).size(), 2U);
    EXPECT_EQ(words({.undecided = true, .coarse = true}).back(), "certified, coarse");
}

TEST(SwatchShapes, HaveStripesWithinTheirSquare) {
    const glm::dvec2 lo(20, 30);
    const Shapes striped = swatch_shapes(lo, 12.0, PixelMark::UndecidedDrawn, plain_style());
    EXPECT_EQ(count_of<ConvexPolygon>(striped), 2);
    for (const Shape& shape : striped) {
        const ConvexPolygon* polygon = std::get_if<ConvexPolygon>(&shape);
        if (polygon == nullptr) continue;
        for (const glm::dvec2& corner : polygon->corners) {
            EXPECT_NEAR(corner.x, 26, 6 + 1e-9);
            EXPECT_NEAR(corner.y, 36, 6 + 1e-9);
        }
    }
    EXPECT_EQ(swatch_shapes(lo, 12.0, PixelMark::UndecidedNotDrawn, plain_style()).size(), 1U);
}

}  // namespace
}  // namespace zeroset::test::legend_test
