#include "engine/annotate/markers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

// Marked points as shapes: where their dots and tags are, and what is hidden.

namespace zeroset::test::markers_test {
namespace {

CardStyle plain_style() {
    return {.unit = 10.0, .em = 10.0, .width = [](std::string_view words, double em) {
                return 0.5 * em * static_cast<double>(words.size());
            }};
}

/// From the front: x to the right, z up; a wall at this distance.
struct Scene {
    Camera camera{{0, -5, 0}, {0, 0, 0}, {0, 0, 1}, 0.6};
    Framebuffer frame{30, 20};

    explicit Scene(float wall = std::numeric_limits<float>::infinity()) {
        std::ranges::fill(frame.depth, wall);
    }
    [[nodiscard]] Shapes shapes(const std::vector<MarkedPoint>& points) const {
        return marker_shapes(points, {frame, camera, {300, 200}}, plain_style());
    }
};

TEST(MarkerShapes, AreADotWithATagBesideIt) {
    const Shapes shapes = Scene().shapes({{{0, 0, 0}, "1"}});
    ASSERT_EQ(shapes.size(), 5U);
    EXPECT_EQ(std::get<Circle>(shapes[0]).middle, glm::dvec2(150, 100));
    EXPECT_EQ(std::get<Circle>(shapes[0]).color, cards_on_dark.accent);
    const auto& tag = std::get<RoundedRectangle>(shapes[3]);
    EXPECT_GT(tag.lo.x, 150 + std::get<Circle>(shapes[0]).radius);
    EXPECT_LT(tag.hi.y, 100);
    EXPECT_EQ(std::get<Text>(shapes[4]).words, "1");
}

TEST(MarkerShapes, HaveARingWhenSelected) {
    EXPECT_EQ(Scene().shapes({{{0, 0, 0}, "1", true}}).size(), 6U);
}

TEST(MarkerShapes, AreFaintRingsBehindASurface) {
    const Shapes shapes = Scene(3.0F).shapes({{{0, 0, 0}, "1"}});
    ASSERT_EQ(shapes.size(), 4U);
    EXPECT_GT(std::get<Circle>(shapes[0]).line, 0.0);
    EXPECT_LT(std::get<Circle>(shapes[0]).color >> 24U, 128U);
    EXPECT_LT(std::get<Text>(shapes[3]).color >> 24U, 160U);
}

TEST(MarkerShapes, LeaveOutWhatIsNotInThePicture) {
    EXPECT_TRUE(Scene().shapes({{{9, 0, 0}, "1"}, {{0, -6, 0}, "2"}}).empty());
}

TEST(TagShapes, StayOnTheCanvas) {
    for (const glm::dvec2 dot : {glm::dvec2(295, 100), {295, 3}, {3, 199}, {150, 0}}) {
        const Shapes shapes = tag_shapes("a few words", dot, 5.0, {300, 200}, plain_style());
        const auto& tag = std::get<RoundedRectangle>(shapes.at(0));
        EXPECT_GE(tag.lo.x, 0.0);
        EXPECT_GE(tag.lo.y, 0.0);
        EXPECT_LE(tag.hi.x, 300.0);
        EXPECT_LE(tag.hi.y, 200.0);
        EXPECT_TRUE(tag.lo.x > dot.x || tag.hi.x < dot.x);
    }
}

}  // namespace
}  // namespace zeroset::test::markers_test
