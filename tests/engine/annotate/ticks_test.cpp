#include "engine/annotate/ticks.hpp"

#include <gtest/gtest.h>

#include <utility>

// The numbers along an axis.

namespace zeroset::test::ticks_test {
namespace {

TEST(Ticks, AreRound) {
    for (const auto& [length, step] : {std::pair{1.0, 1.0},
                                       {1.1, 2.0},
                                       {2.5, 5.0},
                                       {7.0, 10.0},
                                       {0.03, 0.05},
                                       {1e-9, 1e-9},
                                       {3e8, 5e8}}) {
        EXPECT_NEAR(tick_step(length), step, 1e-9 * step) << length;
    }
    EXPECT_EQ(tick_text(0.3, 0.1), "0.3");
    EXPECT_EQ(tick_text(-0.25, 0.05),
              "\xE2\x88\x92"
              "0.25");
    EXPECT_EQ(tick_text(1e-17, 0.1), "0");
    EXPECT_EQ(tick_text(12, 2), "12");
    EXPECT_EQ(tick_text(1.0000002, 1e-7), "1.0000002");
    EXPECT_EQ(tick_text(2e7, 1e7), "2e+07");
    EXPECT_EQ(tick_text(3e-9, 1e-9), "3e-09");
}

}  // namespace
}  // namespace zeroset::test::ticks_test
