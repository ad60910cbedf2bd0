#include "engine/annotate/paint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

// Shapes in an image in memory, by what they cover.

namespace zeroset::test::paint_shapes_test {
namespace {

constexpr std::uint32_t black = 0xFF000000U;
constexpr std::uint32_t white = 0xFFFFFFFFU;

class PaintShapes : public testing::Test {
protected:
    void SetUp() override {
        const auto font = LabelFont::load();
        ASSERT_TRUE(font) << font.error();
        font_ = *font;
    }
    [[nodiscard]] Framebuffer painted(const Shapes& shapes) const {
        Framebuffer picture(60, 40);
        std::ranges::fill(picture.color, black);
        paint_shapes(picture, shapes, *font_);
        return picture;
    }
    /// Sum of all that is painted in white, in pixels.
    [[nodiscard]] double area(const Shapes& shapes) const {
        double sum = 0.0;
        for (const std::uint32_t color : painted(shapes).color)
            sum += (color & 0xFFU) / 255.0;
        return sum;
    }
    /// Columns and rows that differ from black: first and last.
    struct Extent {
        int left = 1000, right = -1, top = 1000, bottom = -1;
    };
    [[nodiscard]] Extent extent(const Shapes& shapes) const {
        const Framebuffer picture = painted(shapes);
        Extent extent;
        for (int row = 0; row < picture.height; ++row) {
            for (int col = 0; col < picture.width; ++col) {
                if ((picture.color[picture.index(col, row)] & 0xFFU) < 96U) continue;
                extent.left = std::min(extent.left, col);
                extent.right = std::max(extent.right, col);
                extent.top = std::min(extent.top, row);
                extent.bottom = std::max(extent.bottom, row);
            }
        }
        return extent;
    }

    std::optional<LabelFont> font_;
};

TEST_F(PaintShapes, CoverTheirAreas) {
    constexpr double pi = std::numbers::pi;
    const Circle disc{{30.3, 19.8}, 9.5, white};
    EXPECT_NEAR(area({disc}), pi * 9.5 * 9.5, 1.0);
    EXPECT_NEAR(area({Circle{{30.3, 19.8}, 9.5, white, 2.0}}), 2.0 * pi * 9.5 * 2.0, 1.0);
    EXPECT_NEAR(area({Circle{{30.3, 19.8}, 9.5, white, 0.5}}), 2.0 * pi * 9.5 * 0.5, 1.0);
    const RoundedRectangle sharp{.lo = {10.25, 5.5}, .hi = {40.5, 30.25}, .color = white};
    EXPECT_NEAR(area({sharp}), 30.25 * 24.75, 1.0);
    RoundedRectangle round = sharp;
    round.radius = 6.0;
    EXPECT_NEAR(area({round}), 30.25 * 24.75 - (4.0 - pi) * 36.0, 1.5);
    round.line = 1.0;
    EXPECT_NEAR(area({round}), 2.0 * (29.25 + 23.75) - (8.0 - 2.0 * pi) * 5.5, 1.5);
    for (const bool turned : {false, true}) {
        ConvexPolygon triangle{{{5, 5}, {45, 8}, {20, 35}}, white};
        if (turned) std::ranges::reverse(triangle.corners);
        EXPECT_NEAR(area({triangle}), 0.5 * (40.0 * 30.0 - 15.0 * 3.0), 3.0);
    }
}

TEST_F(PaintShapes, ShowAMapFromLeftToRight) {
    const Framebuffer picture = painted({MapBar{{5, 5}, {55, 15}, ColorMap::Ember}});
    EXPECT_EQ(picture.color[picture.index(5, 9)], shown_color_at(ColorMap::Ember, 0.01));
    EXPECT_EQ(picture.color[picture.index(54, 9)], shown_color_at(ColorMap::Ember, 0.99));
    EXPECT_EQ(picture.color[picture.index(4, 9)], black);
    EXPECT_EQ(picture.color[picture.index(5, 15)], black);
}

TEST_F(PaintShapes, PutTextWhereItsAnchorSays) {
    const auto text = [&](Anchor anchor) {
        return extent(
            {Text{.words = "000", .at = {30, 16}, .anchor = anchor, .em = 12.0, .color = white}});
    };
    const double width = font_->width("000", 12.0);
    EXPECT_NEAR(text(Anchor::Middle).left, 30 - 0.5 * width, 1.5);
    EXPECT_NEAR(0.5 * (text(Anchor::Middle).top + text(Anchor::Middle).bottom + 1), 16, 1.0);
    EXPECT_NEAR(text(Anchor::TopLeft).left, 30, 1.5);
    EXPECT_NEAR(text(Anchor::TopRight).right + 1, 30, 1.5);
    EXPECT_NEAR(text(Anchor::TopMiddle).left, text(Anchor::Middle).left, 1);
    EXPECT_GE(text(Anchor::TopLeft).top, 16);
    EXPECT_LE(text(Anchor::TopLeft).bottom, 16 + line_height_em * 12.0);
}

TEST_F(PaintShapes, PutAnOutlineAboutLetters) {
    Text text{.words = "0", .at = {30, 16}, .em = 16.0, .color = white};
    const Extent plain = extent({text});
    text.outline = white;
    const Extent outlined = extent({text});
    EXPECT_LT(outlined.left, plain.left);
    EXPECT_GT(outlined.bottom, plain.bottom);
}

TEST_F(PaintShapes, ChangeNothingBeyondThePicture) {
    const Shapes beyond{Circle{{-1e7, 5}, 3.0, white}, ConvexPolygon{{{1, 1}, {2, 2}}, white},
                        RoundedRectangle{.lo = {100, 100}, .hi = {1e9, 1e9}, .color = white},
                        MapBar{{-50, -50}, {-5, -5}},
                        Text{.words = "1", .at = {-1e4, 3}, .color = white}};
    EXPECT_EQ(area(beyond), 0.0);
    EXPECT_NEAR(area({RoundedRectangle{.lo = {-1e6, -1e6}, .hi = {1e6, 1e6}, .color = white}}),
                60 * 40, 1e-9);
}

TEST_F(PaintShapes, ForgetWhichRowsWereBlank) {
    Framebuffer picture(8, 8);
    picture.blank_rows = {1};
    paint_shapes(picture, {Circle{{4, 4}, 2.0, white}}, *font_);
    EXPECT_TRUE(picture.blank_rows.empty());
}

}  // namespace
}  // namespace zeroset::test::paint_shapes_test
