#include "engine/render/resolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

// How fine pictures are while something moves.

namespace zeroset::test::resolution_test {
namespace {

constexpr std::size_t pixels = 1'000'000;

/// Measures a picture at a scale, where the full one costs `full_ms`.
void draw(ResolutionGovernor& governor, double full_ms, double scale) {
    governor.measured(static_cast<std::size_t>(pixels * scale * scale),
                      full_ms * std::pow(scale, 1.6));
}

TEST(Resolution, StartsCoarseWhereNothingIsKnown) {
    ResolutionGovernor governor(12.0);
    EXPECT_EQ(governor.expected_ms(pixels), 0.0);
    EXPECT_EQ(governor.choose(pixels), 0.25);
    draw(governor, 1.0, 0.25);
    EXPECT_EQ(governor.choose(pixels), 1.0);
    governor.forget();
    EXPECT_EQ(governor.choose(pixels), 0.25);
}

TEST(Resolution, IsTheFinestThatFits) {
    for (const double full_ms : {1.0, 9.0, 13.0, 30.0, 100.0, 300.0}) {
        ResolutionGovernor governor(12.0);
        draw(governor, full_ms, 0.25);
        EXPECT_NEAR(governor.expected_ms(pixels), full_ms, 1e-2 * full_ms);
        const double scale = governor.choose(pixels);
        EXPECT_LE(full_ms * std::pow(scale, 1.6), 1.2 * 12.0) << full_ms;
        // The next finer one is not sure to fit: it is at most a half finer.
        if (scale == 1.0) continue;
        EXPECT_GE(full_ms * std::pow(1.5 * scale, 1.6), 0.8 * 12.0) << full_ms;
    }
}

TEST(Resolution, NeverFallsBelowAnEighth) {
    ResolutionGovernor governor(12.0);
    draw(governor, 1e6, 0.25);
    EXPECT_EQ(governor.choose(pixels), 0.125);
}

TEST(Resolution, StaysWhileTheCostWavers) {
    ResolutionGovernor governor(12.0);
    draw(governor, 30.0, 0.25);
    const double scale = governor.choose(pixels);
    EXPECT_EQ(scale, 0.5);
    for (int i = 0; i < 100; ++i) {
        draw(governor, 30.0 * (i % 2 == 0 ? 0.9 : 1.1), scale);
        EXPECT_EQ(governor.choose(pixels), scale) << i;
    }
}

TEST(Resolution, FollowsTheCost) {
    ResolutionGovernor governor(12.0);
    draw(governor, 10.0, 1.0);
    EXPECT_EQ(governor.choose(pixels), 1.0);
    draw(governor, 200.0, 1.0);
    const double coarse = governor.choose(pixels);  // at once
    EXPECT_LT(coarse, 0.25);
    for (int i = 0; i < 20; ++i)
        draw(governor, 5.0, coarse);
    EXPECT_EQ(governor.choose(pixels), 1.0);
}

TEST(Resolution, DependsOnTheSizeOfThePicture) {
    ResolutionGovernor governor(12.0);
    draw(governor, 10.0, 1.0);
    EXPECT_EQ(governor.choose(pixels), 1.0);
    EXPECT_LT(governor.choose(4 * pixels), 1.0);
}

}  // namespace
}  // namespace zeroset::test::resolution_test
