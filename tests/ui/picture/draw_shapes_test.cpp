#include "ui/picture/draw_shapes.hpp"

#include "engine/annotate/label_font.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/annotate/markers.hpp"
#include "engine/annotate/paint.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/offscreen_window.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <vector>

// The two painters of shapes, the window's and the one in memory, beside each other.

namespace zeroset::ui::draw_shapes_test {
namespace {

constexpr int width = 320;
constexpr int height = 160;
constexpr std::uint32_t ground = 0xFF406080U;

/// A function that makes shapes in a style.
using Maker = std::function<Shapes(const CardStyle&)>;

/// The shapes on a flat ground, as OpenGL draws them, and in `shapes`; empty where there is none.
Framebuffer drawn_by_opengl(const Maker& make, Shapes& shapes) {
    const auto window = make_offscreen_window({.width = width, .height = height, .scale = 1.0F});
    if (!window) return {};
    for (int frame = 0; frame < 2; ++frame) {
        (*window)->begin_frame(Theme::Dark);
        ImDrawList& canvas = *ImGui::GetBackgroundDrawList();
        canvas.AddRectFilled(ImVec2(0, 0), ImVec2(width, height), ground);
        shapes = make(card_style(Theme::Dark));
        draw_shapes(canvas, ImVec2(0, 0), shapes);
        (*window)->end_frame();
    }
    return (*window)->pixels();
}

/// The greatest difference of the mean red, green or blue of a square of pixels: smooth edges and
/// letters may differ from pixel to pixel.
int worst_square(const Framebuffer& a, const Framebuffer& b, int square) {
    int worst = 0;
    for (int row = 0; row + square <= a.height; row += square) {
        for (int col = 0; col + square <= a.width; col += square) {
            std::array<int, 3> sums{};
            for (int i = 0; i < square * square; ++i) {
                const std::size_t at = a.index(col + i % square, row + i / square);
                for (unsigned c = 0; c < 3; ++c) {
                    sums.at(c) += static_cast<int>(a.color[at] >> (8U * c) & 0xFFU) -
                                  static_cast<int>(b.color[at] >> (8U * c) & 0xFFU);
                }
            }
            for (const int sum : sums)
                worst = std::max(worst, std::abs(sum) / (square * square));
        }
    }
    return worst;
}

void expect_alike(const Maker& make, int most) {
    Shapes shapes;
    const Framebuffer drawn = drawn_by_opengl(make, shapes);
    if (drawn.color.empty()) GTEST_SKIP() << "no OpenGL";
    const auto font = LabelFont::load();
    ASSERT_TRUE(font) << font.error();
    ASSERT_FALSE(shapes.empty());
    Framebuffer painted(width, height);
    std::ranges::fill(painted.color, ground);
    paint_shapes(painted, shapes, *font);
    EXPECT_LE(worst_square(drawn, painted, 8), most);
    Framebuffer empty(width, height);
    std::ranges::fill(empty.color, ground);
    EXPECT_GT(worst_square(drawn, empty, 8), 2 * most);
}

TEST(ShapePainters, DrawALegendAlike) {
    Coloring coloring;
    coloring.by = ColorBy::Depth;
    coloring.range = ValueRange{1.25, 7.5};
    const Legend legend = legend_of(coloring, "");
    expect_alike(
        [&](const CardStyle& style) {
            return legend_shapes({.legend = &legend, .undecided = true}, {width, height},
                                 {2.0 * width, 4.0 * height}, style);
        },
        16);
}

TEST(ShapePainters, DrawAMarkerAlike) {
    const Camera camera{{0, -5, 0}, {0, 0, 0}, {0, 0, 1}, 0.6};
    Framebuffer frame(width, height);
    std::ranges::fill(frame.depth, 100.0F);
    const std::vector<MarkedPoint> points{{{0, 0, 0}, "1", true}, {{0.5, 0, 0.3}, "12"}};
    expect_alike(
        [&](const CardStyle& style) {
            return marker_shapes(points, {frame, camera, {width, height}}, style);
        },
        16);
}

TEST(ShapePainters, DrawPlainShapesAlike) {
    expect_alike(
        [](const CardStyle&) {
            return Shapes{
                Circle{{40, 40}, 20.0, 0xFFFFFFFFU},
                Circle{{100, 40}, 20.0, 0xFF2040E0U, 4.0},
                RoundedRectangle{
                    .lo = {130, 20}, .hi = {180, 60}, .radius = 8.0, .color = 0xC0F0F0F0U},
                RoundedRectangle{.lo = {190, 20},
                                 .hi = {240, 60},
                                 .radius = 8.0,
                                 .color = 0xFFFFFFFFU,
                                 .line = 3.0},
                ConvexPolygon{{{20, 80}, {70, 90}, {40, 130}}, 0xFF30F060U},
                Line{{90, 80}, {200, 140}, 4.0, 0xFFFFFFFFU},
                MapBar{{210, 80}, {300, 110}, ColorMap::Ember}};
        },
        24);
}

TEST(CardStyle, HasTheDarkThemesColoursInPictures) {
    const auto window = make_offscreen_window({.width = width, .height = height, .scale = 1.0F});
    if (!window) GTEST_SKIP() << "no OpenGL";
    (*window)->begin_frame(Theme::Dark);
    EXPECT_EQ(card_style(Theme::Dark).colors, cards_on_dark);
    EXPECT_NE(card_style(Theme::Light).colors, cards_on_dark);
    (*window)->end_frame();
}

}  // namespace
}  // namespace zeroset::ui::draw_shapes_test
