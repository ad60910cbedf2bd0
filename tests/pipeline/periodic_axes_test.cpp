#include "pipeline/periodic_axes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>

namespace zeroset::test::periodic_axes_test {
namespace {

using Axes = std::array<bool, 3>;

Axes axes_of(std::string_view text) {
    const auto program = read_program(text);
    return program ? periodic_axes(*program) : Axes{};
}

TEST(PeriodicAxes, AreThoseOfAngles) {
    EXPECT_EQ(axes_of("z = sin(x) cos(y)"), (Axes{true, true, false}));
    EXPECT_EQ(axes_of("sin x + sin y + sin z = 0"), (Axes{true, true, true}));
    EXPECT_EQ(axes_of("z = y^2 + sin(2x + 1)^2 / 3"), (Axes{true, false, false}));
    EXPECT_EQ(axes_of("z = tan(x/4) exp(cos(3(x - y)))"), (Axes{true, true, false}));
    EXPECT_EQ(axes_of("z = sin x; z = 2"), (Axes{true, false, false}));
}

TEST(PeriodicAxes, AreNotThoseThatDoNotRepeatThemselves) {
    EXPECT_EQ(axes_of("z = x sin x"), Axes{});
    EXPECT_EQ(axes_of("z = sin(x^2)"), Axes{});
    EXPECT_EQ(axes_of("z = sin x; x = 1"), Axes{});
    EXPECT_EQ(axes_of("x^2 + y^2 + z^2 = 1"), Axes{});
    EXPECT_EQ(axes_of("z = sin(2 pi x)"), Axes{}) << "it has the period 1";
    EXPECT_EQ(axes_of("z = sin(a x)"), Axes{}) << "its period changes";
}

}  // namespace
}  // namespace zeroset::test::periodic_axes_test
