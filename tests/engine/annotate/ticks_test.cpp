#include "engine/annotate/ticks.hpp"

#include "engine/base/translation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(Ticks, AreMultiplesOfPiInLowestTerms) {
    const TickStep quarter{.num = 1, .den = 4, .of_pi = true};
    EXPECT_EQ(tick_label(0, quarter), "0");
    EXPECT_EQ(tick_label(1, quarter), "\u03C0/4");
    EXPECT_EQ(tick_label(-2, quarter), "\u2212\u03C0/2");
    EXPECT_EQ(tick_label(4, quarter), "\u03C0");
    EXPECT_EQ(tick_label(6, quarter), "3\u03C0/2");
    EXPECT_EQ(tick_label(3, {.num = 2, .of_pi = true}), "6\u03C0");
}

TEST(Ticks, OfPiAreAsFarApartAsIsWished) {
    for (const double length : {0.1, 0.3, 0.6, 1.0, 2.0, 4.0, 20.0, 300.0}) {
        const TickStep step = tick_step_of(length, true);
        EXPECT_TRUE(step.of_pi) << length;
        EXPECT_GE(step.length(), length * (1.0 - 1e-9));
        EXPECT_LE(step.length(), std::max(3.2 * length, 0.27));
    }
    EXPECT_FALSE(tick_step_of(1e-3, true).of_pi) << "a deep view";
    EXPECT_EQ(tick_step_of(0.3, false), (TickStep{.num = 0.5}));
}

TEST(Ticks, HaveTheDecimalMarkOfTheLanguage) {
    const WithTextStyle german({.language = Language::German, .decimal_mark = ','});
    EXPECT_EQ(tick_label(3, {.num = 0.5}), "1,5");
}

}  // namespace
}  // namespace zeroset::test::ticks_test
