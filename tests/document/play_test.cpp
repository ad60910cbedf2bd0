// Tests of sliders: playing, steps, and values beyond their ends.

#include "document/play.hpp"

#include "document/document.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace zeroset::test::play_test {
namespace {

Slider slider(double value, Repeat repeat) { return {value, 0.0, 4.0, 0.0, 1.0, repeat}; }

TEST(Play, BouncesBetweenTheEnds) {
    Slider moving = slider(3.0, Repeat::Bounce);
    PlayState playing = started(moving);
    const double range_s = seconds_per_range;
    for (const auto& [elapsed, value] : {std::pair(0.25 * range_s, 4.0),
                                         {0.25 * range_s, 3.0},
                                         {0.75 * range_s, 0.0},
                                         {0.5 * range_s, 2.0},
                                         {2.0 * range_s, 2.0}}) {
        advance(moving, playing, elapsed);
        EXPECT_NEAR(moving.value, value, 1e-12);
    }
}

TEST(Play, LoopsFromEndToStart) {
    Slider moving = slider(3.0, Repeat::Loop);
    moving.speed = 2.0;
    PlayState playing = started(moving);
    advance(moving, playing, 0.25 * seconds_per_range);
    EXPECT_NEAR(moving.value, 1.0, 1e-12);
}

TEST(Play, GoesByStepsAndKeepsItsPlaceBetweenThem) {
    Slider moving{0.0, 0.0, 1.0, 0.25, 1.0, Repeat::Bounce};
    PlayState playing = started(moving);
    for (const double value : {0.0, 0.25, 0.25, 0.5, 0.5}) {
        advance(moving, playing, 0.1 * seconds_per_range);
        EXPECT_DOUBLE_EQ(moving.value, value);
    }
}

TEST(Steps, StayWithinTheEnds) {
    const Slider uneven{0.0, -1.0, 1.0, 0.3, 1.0, Repeat::Bounce};
    EXPECT_DOUBLE_EQ(on_step(uneven, -3.0), -1.0);
    EXPECT_NEAR(on_step(uneven, 3.0), 0.8, 1e-12);
    EXPECT_NEAR(on_step(uneven, 0.0), -0.1, 1e-12);
    EXPECT_EQ(on_step(Slider{}, 0.123), 0.123);
}

TEST(SetValue, MovesTheEndsThatItPasses) {
    Slider slider;
    set_value(slider, 7.0);
    EXPECT_EQ(slider, (Slider{.value = 7.0, .hi = 7.0}));
    set_value(slider, -6.0);
    EXPECT_EQ(slider, (Slider{.value = -6.0, .lo = -6.0, .hi = 7.0}));
}

}  // namespace
}  // namespace zeroset::test::play_test
