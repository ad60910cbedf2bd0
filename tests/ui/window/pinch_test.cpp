#include "ui/window/pinch.hpp"

#include <gtest/gtest.h>

namespace zeroset::ui::pinch_test {
namespace {

constexpr std::int32_t one = 1 << 16;

TEST(Pinch, StepsMultiplyToTheWholePinch) {
    PinchSteps steps;
    EXPECT_EQ(steps.follow({.begins = true, .spread = one}), 1.0);
    EXPECT_EQ(steps.follow({.spread = one + one / 2}), 1.5);
    EXPECT_EQ(steps.follow({.spread = 3 * one}), 2.0);
    EXPECT_EQ(steps.follow({.spread = 3 * one}), 1.0)
        << "its end tells where the fingers are again";
}

TEST(Pinch, TheNextOneBeginsAnew) {
    PinchSteps steps;
    steps.follow({.begins = true, .spread = one});
    steps.follow({.spread = 4 * one});
    EXPECT_EQ(steps.follow({.begins = true, .spread = one}), 1.0);
    EXPECT_EQ(steps.follow({.spread = one / 2}), 0.5);
}

TEST(Pinch, FingersThatAreNowhereChangeNothing) {
    PinchSteps steps;
    steps.follow({.begins = true, .spread = one});
    EXPECT_EQ(steps.follow({.spread = 0}), 1.0);
    EXPECT_EQ(steps.follow({.spread = -one}), 1.0);
    EXPECT_EQ(steps.follow({.spread = 2 * one}), 2.0);
}

}  // namespace
}  // namespace zeroset::ui::pinch_test
