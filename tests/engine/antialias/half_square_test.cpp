#include "engine/antialias/half_square.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

// Parts of a square on one side of a line.

namespace zeroset::test::half_square_test {
namespace {

/// The part by counting places of a fine grid.
SquarePart counted(const LinearOnSquare& f) {
    constexpr int side = 400;
    double count = 0.0;
    double x_sum = 0.0;
    double y_sum = 0.0;
    for (int i = 0; i < side; ++i) {
        for (int k = 0; k < side; ++k) {
            const double x = (2.0 * i + 1.0) / side - 1.0;
            const double y = (2.0 * k + 1.0) / side - 1.0;
            if (f.value + f.by_x * x + f.by_y * y > 0.0) continue;
            count += 1.0;
            x_sum += x;
            y_sum += y;
        }
    }
    if (count == 0.0) return {.share = 0.0, .x = 0.0, .y = 0.0};
    return {.share = count / side / side, .x = x_sum / count, .y = y_sum / count};
}

TEST(HalfSquare, IsTheCountedPart) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < 100; ++i) {
        const LinearOnSquare f{
            .value = number(random), .by_x = number(random), .by_y = number(random)};
        const SquarePart part = part_below_zero(f);
        const SquarePart expected = counted(f);
        EXPECT_NEAR(part.share, expected.share, 0.004);
        if (expected.share < 0.02) continue;
        EXPECT_NEAR(part.x, expected.x, 0.01);
        EXPECT_NEAR(part.y, expected.y, 0.01);
    }
}

TEST(HalfSquare, BothSidesMakeTheSquare) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const LinearOnSquare f{
            .value = number(random), .by_x = number(random), .by_y = number(random)};
        const SquarePart a = part_below_zero(f);
        const SquarePart b = part_below_zero({.value = -f.value, .by_x = -f.by_x, .by_y = -f.by_y});
        EXPECT_NEAR(a.share + b.share, 1.0, 1e-12);
        EXPECT_NEAR(a.share * a.x + b.share * b.x, 0.0, 1e-12);
        EXPECT_NEAR(a.share * a.y + b.share * b.y, 0.0, 1e-12);
    }
}

TEST(HalfSquare, TheRestIsTheOtherSide) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        // Some lines run along a side.
        const LinearOnSquare f{.value = number(random),
                               .by_x = i % 5 == 0 ? 0.0 : number(random),
                               .by_y = i % 7 == 0 ? 0.0 : number(random)};
        const SquarePart rest = part_below_zero(f).rest();
        const SquarePart other = part_below_zero(-f);
        ASSERT_NEAR(rest.share, other.share, 1e-12);
        ASSERT_NEAR(rest.share * rest.x, other.share * other.x, 1e-12);
        ASSERT_NEAR(rest.share * rest.y, other.share * other.y, 1e-12);
    }
}

TEST(HalfSquare, IsAllOrNothing) {
    EXPECT_EQ(part_below_zero({.value = -3.0, .by_x = 1.0, .by_y = 1.0}).share, 1.0);
    EXPECT_EQ(part_below_zero({.value = 3.0, .by_x = 1.0, .by_y = 1.0}).share, 0.0);
    EXPECT_EQ(part_below_zero({.value = 0.0, .by_x = 0.0, .by_y = 0.0}).share, 1.0);
}

}  // namespace
}  // namespace zeroset::test::half_square_test
