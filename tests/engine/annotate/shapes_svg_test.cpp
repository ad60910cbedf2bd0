#include "engine/annotate/shapes_svg.hpp"

#include <gtest/gtest.h>

#include <string>

// Shapes as SVG: each kind, its place and its colour.

namespace zeroset::test::shapes_svg_test {
namespace {

constexpr std::uint32_t red = 0xff0000ffU;
constexpr std::uint32_t half_blue = 0x80ff0000U;

std::string svg(Shape shape) { return svg_of({std::move(shape)}, {40, 30}, 0xffffffffU); }

TEST(ShapesSvg, HasSizeAndGround) {
    const std::string text = svg_of({}, {40, 30}, 0xff332211U);
    EXPECT_TRUE(text.starts_with("<?xml"));
    EXPECT_TRUE(text.ends_with("</svg>\n"));
    EXPECT_NE(text.find("viewBox=\"0 0 40 30\""), std::string::npos);
    EXPECT_NE(text.find("<rect x=\"0\" y=\"0\" width=\"40\" height=\"30\" fill=\"#112233\"/>"),
              std::string::npos);
}

TEST(ShapesSvg, WritesEachKind) {
    EXPECT_NE(svg(Line{.from = {1, 2}, .to = {3, 4.125}, .width = 1.5, .color = red})
                  .find("<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4.13\" stroke=\"#ff0000\" "
                        "stroke-width=\"1.5\"/>"),
              std::string::npos);
    EXPECT_NE(
        svg(Circle{.middle = {5, 6}, .radius = 2, .color = half_blue})
            .find("<circle cx=\"5\" cy=\"6\" r=\"2\" fill=\"#0000ff\" fill-opacity=\"0.5\"/>"),
        std::string::npos);
    EXPECT_NE(svg(Circle{.middle = {5, 6}, .radius = 2, .color = red, .line = 1})
                  .find("fill=\"none\" stroke=\"#ff0000\" stroke-width=\"1\""),
              std::string::npos);
    EXPECT_NE(
        svg(RoundedRectangle{.lo = {1, 1}, .hi = {9, 5}, .radius = 2, .color = red, .line = 2})
            .find("<rect x=\"2\" y=\"2\" width=\"6\" height=\"2\" rx=\"2\" fill=\"none\""),
        std::string::npos);
    EXPECT_NE(svg(ConvexPolygon{.corners = {{0, 0}, {2, 0}, {0, 2}}, .color = red})
                  .find("<polygon points=\"0,0 2,0 0,2\" fill=\"#ff0000\"/>"),
              std::string::npos);
    const std::string bar = svg(MapBar{.lo = {0, 0}, .hi = {32, 4}});
    EXPECT_NE(bar.find("width=\"0.5\" height=\"4\""), std::string::npos);
}

TEST(ShapesSvg, PlacesTexts) {
    Text text{
        .words = "a < b & c", .at = {10, 20}, .anchor = Anchor::TopRight, .em = 10, .color = red};
    EXPECT_NE(svg(text).find("<text x=\"10\" y=\"29.28\" font-size=\"10\" text-anchor=\"end\" "
                             "fill=\"#ff0000\">a &lt; b &amp; c</text>"),
              std::string::npos);
    text.anchor = Anchor::TopLeft;
    EXPECT_NE(svg(text).find("text-anchor=\"start\""), std::string::npos);
    text.anchor = Anchor::Middle;
    text.outline = 0xffffffffU;
    const std::string middle = svg(text);
    EXPECT_NE(middle.find("y=\"23.65\""), std::string::npos) << middle;
    EXPECT_NE(middle.find("paint-order=\"stroke\""), std::string::npos);
}

}  // namespace
}  // namespace zeroset::test::shapes_svg_test
