#include "engine/measure/extent.hpp"

#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

// How far surfaces reach, found by enclosures.

namespace zeroset::test::extent_test {
namespace {

/// Expects `found` to hold `exact` and to be no larger than by some of its smallest cells.
void expect_holds(const std::optional<Box>& found, const Box& exact, const std::string& what) {
    ASSERT_TRUE(found) << what;
    const double slack = 3.0 / 64.0 * exact.size();
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(found->lo[i], exact.lo[i]) << what;
        EXPECT_GE(found->lo[i], exact.lo[i] - slack) << what;
        EXPECT_GE(found->hi[i], exact.hi[i]) << what;
        EXPECT_LE(found->hi[i], exact.hi[i] + slack) << what;
    }
}

TEST(Extent, IsThatOfABoundedSurface) {
    struct Case {
        std::string text;
        Box exact;
    };
    const Case cases[] = {
        {"x^2 + y^2 + z^2 - 1", Box::cube(1)},
        {"(x - 1)^2 + (y + 2)^2 + (z - 0.5)^2 - 0.01", {{0.9, -2.1, 0.4}, {1.1, -1.9, 0.6}}},
        {"x^2 + y^2 + z^2 - 900", Box::cube(30)},
        {"(x - 40)^2 + y^2 + z^2 - 1", {{39, -1, -1}, {41, 1, 1}}},
        {"(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.0625", {{-1.25, -1.25, -0.25}, {1.25, 1.25, 0.25}}},
        {"max(abs(x) - 1, abs(y) - 0.5, abs(z) - 0.25)", {{-1, -0.5, -0.25}, {1, 0.5, 0.25}}},
        {"x^2 + y^2 + z^2 - 2.5e5", Box::cube(500)},
        {"(x - 3000)^2 + y^2 + z^2 - 1e4", {{2900, -100, -100}, {3100, 100, 100}}},
        {"x^2 + y^2 + z^2 - 1e11", Box::cube(316227.766)},
        {"(x - 1)^2 + y^2 + z^2 - 1e-12", {{1 - 1e-6, -1e-6, -1e-6}, {1 + 1e-6, 1e-6, 1e-6}}}};
    for (const auto& [text, exact] : cases) {
        const Extent extent = find_extent(scene_of(text, Box::cube(2)));
        expect_holds(extent.whole, exact, text);
    }
}

TEST(Extent, OfTheClipBoxIsWhatItHolds) {
    const Extent extent = find_extent(scene_of("x^2 + y^2 + z^2 - 900", {{0, -2, -3}, {40, 2, 3}}));
    expect_holds(extent.inside, {{29.782, -2, -3}, {30, 2, 3}}, "a part of a sphere");
    EXPECT_FALSE(extent.reached);
}

TEST(Extent, OfAnUnboundedSurfaceIsNotKnown) {
    for (const std::string text : {"z", "x^2 + y^2 - z^2 - 1", "sin(x) + sin(y) + sin(z)"}) {
        const Extent extent = find_extent(scene_of(text, Box::cube(2)));
        EXPECT_FALSE(extent.whole) << text;
        ASSERT_TRUE(extent.inside) << text;
    }
    const Extent plane = find_extent(scene_of("z - 0.5", Box::cube(2)));
    EXPECT_EQ(plane.inside->lo.x, -2);
    EXPECT_EQ(plane.inside->hi.y, 2);
    EXPECT_NEAR(plane.inside->lo.z, 0.5, 0.15);
    EXPECT_NEAR(plane.inside->hi.z, 0.5, 0.15);
}

TEST(Extent, OfAnEmptySurfaceIsNothing) {
    for (const std::string text :
         {"x^2 + y^2 + z^2 + 1", "sqrt(-1 - x^2)", "exp(x) + 1", "x + y^2 - 1e6"}) {
        const Extent extent = find_extent(scene_of(text, Box::cube(2)));
        EXPECT_FALSE(extent.whole || extent.inside || extent.reached) << text;
    }
}

TEST(Extent, ReachesOutOfAClipBoxWithoutSurface) {
    const Extent extent = find_extent(scene_of("x - 7", Box::cube(1)));
    EXPECT_FALSE(extent.whole);
    EXPECT_FALSE(extent.inside);
    ASSERT_TRUE(extent.reached);
    EXPECT_EQ(*extent.reached, Box::cube(8));
}

TEST(Extent, OfASurfaceFarAwayIsFoundAcrossTheWallOfASmallerSpace) {
    const Extent extent = find_extent(scene_of("x^2 + y^2 + (z - 8192)^2 - 1e4", Box::cube(2)));
    expect_holds(extent.whole, {{-100, -100, 8092}, {100, 100, 8292}}, "a ball");
}

TEST(Extent, OfSeveralSurfacesHoldsAll) {
    Scene scene = scene_of("(x - 3)^2 + y^2 + z^2 - 1", Box::cube(2));
    scene.surfaces.push_back(scene_of("x^2 + y^2 + (z + 1)^2 - 0.25", Box::cube(2)).surfaces[0]);
    expect_holds(find_extent(scene).whole, {{-0.5, -1, -1.5}, {4, 1, 1}}, "two spheres");
}

}  // namespace
}  // namespace zeroset::test::extent_test
