#include "engine/num/interval.hpp"

#include "engine/num/elementary.hpp"
#include "engine/num/rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

// Hand-picked cases in which the enclosure is known exactly. That it encloses at all is tested by
// tests/property.

namespace zeroset {
namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();
using Range = Interval<float>;

Range range(float lo, float hi) { return {-lo, hi}; }

void expect_range(const Range& found, float lo, float hi) {
    EXPECT_EQ(-found.neg_lo, lo);
    EXPECT_EQ(found.hi, hi);
}

class IntervalCases : public ::testing::Test {
private:
    UpwardRounding upward_;
};

TEST_F(IntervalCases, Sums) {
    expect_range(range(1, 2) + range(-3, 5), -2, 7);
    expect_range(range(1, 2) - range(-3, 5), -4, 5);
    expect_range(-range(1, 2), -2, -1);
    expect_range(range(-unbounded, 2) + range(1, 1), -unbounded, 3);
}

TEST_F(IntervalCases, ProductsOfEverySign) {
    expect_range(range(2, 3) * range(5, 7), 10, 21);
    expect_range(range(2, 3) * range(-7, -5), -21, -10);
    expect_range(range(-3, -2) * range(-7, -5), 10, 21);
    expect_range(range(-2, 3) * range(5, 7), -14, 21);
    expect_range(range(-2, 3) * range(-7, -5), -21, 14);
    expect_range(range(-2, 3) * range(-5, 7), -15, 21);
    expect_range(range(0, 0) * range(-5, 7), 0, 0);
    expect_range(range(-0.0F, 0) * range(-5, 7), 0, 0);
}

TEST_F(IntervalCases, ProductsOfNonnegativeFactors) {
    expect_range(multiply_nonnegative(range(2, 3), range(5, 7)), 10, 21);
    expect_range(multiply_nonnegative(range(0, 3), range(0, unbounded)), 0, unbounded);
    expect_range(multiply_nonnegative_by(range(2, 3), range(-5, 7)), -15, 21);
    expect_range(multiply_nonnegative_by(range(2, 3), range(-7, -5)), -21, -10);
    expect_range(multiply_nonnegative_by(range(0, 3), range(-7, -5)), -21, 0);
}

TEST_F(IntervalCases, ProductsOfZeroAndTheLine) {
    expect_range(range(0, 0) * whole_line(0.0F), -unbounded, unbounded);
    expect_range(scale(whole_line(0.0F), -2.0), -unbounded, unbounded);
    expect_range(scale(range(1, 2), -3.0), -6, -3);
}

TEST_F(IntervalCases, EvenPowersAreTight) {
    for (const int n : {2, 4, 6, 8, 16}) {
        const auto top = static_cast<float>(std::pow(2.0, n));
        expect_range(power(range(-1, 2), n, false), 0, top);
        expect_range(power(range(-2, 1), n, false), 0, top);
        expect_range(power(range(-2, -1), n, false), 1, top);
        expect_range(power(range(1, 2), n, false), 1, top);
        expect_range(power(whole_line(0.0F), n, false), 0, unbounded);
    }
}

TEST_F(IntervalCases, OddPowersAreMonotone) {
    for (const int n : {3, 5, 7, 9}) {
        const auto top = static_cast<float>(std::pow(2.0, n));
        expect_range(power(range(-2, 2), n, false), -top, top);
        expect_range(power(range(-2, -1), n, false), -top, -1);
        expect_range(power(range(1, 2), n, true), 1, top);
        expect_range(power(range(0, 2), n, true), 0, top);
        expect_range(power(whole_line(0.0F), n, false), -unbounded, unbounded);
    }
}

TEST_F(IntervalCases, AbsoluteValues) {
    expect_range(absolute(range(-2, 1)), 0, 2);
    expect_range(absolute(range(-2, -1)), 1, 2);
    expect_range(absolute(range(1, 2)), 1, 2);
}

TEST_F(IntervalCases, RootsOfSquaresAreExact) {
    for (int i = 0; i <= 4096; ++i) {
        const auto root = static_cast<float>(i);
        expect_range(square_root(point(root * root)), root, root);
    }
    expect_range(square_root(range(-3, 4)), 0, 2);
    expect_range(square_root(range(0, unbounded)), 0, unbounded);
}

TEST_F(IntervalCases, RootsAreNarrow) {
    const Range root = square_root(point(2.0F));
    EXPECT_LE(root.hi + root.neg_lo, 4 * 0x1p-23F);
}

TEST_F(IntervalCases, Quotients) {
    expect_range(range(1, 6) / range(2, 4), 0.25F, 3);
    expect_range(range(1, 6) / range(-4, -2), -3, -0.25F);
    expect_range(range(-1, 6) / range(2, 4), -0.5F, 3);
}

TEST_F(IntervalCases, QuotientsByARangeThatTouchesZero) {
    expect_range(range(1, 2) / range(0, 4), 0.25F, unbounded);
    expect_range(range(1, 2) / range(-0.0F, 4), 0.25F, unbounded);
    expect_range(range(-2, -1) / range(0, 4), -unbounded, -0.25F);
    expect_range(range(1, 2) / range(-4, 0), -unbounded, -0.25F);
    expect_range(range(1, 2) / range(-4, -0.0F), -unbounded, -0.25F);
    expect_range(range(-1, 2) / range(0, 4), -unbounded, unbounded);
}

TEST_F(IntervalCases, QuotientsByARangeAroundZeroAreTheLine) {
    expect_range(range(1, 2) / range(-1, 4), -unbounded, unbounded);
    expect_range(range(0, 0) / range(-1, 4), -unbounded, unbounded);
    expect_range(range(-1, 2) / range(0, 0), -unbounded, unbounded);
}

TEST_F(IntervalCases, OverflowKeepsTheLowerEndFinite) {
    const float large = std::numeric_limits<float>::max();
    expect_range(range(large, large) * range(2, 2), large, unbounded);
    expect_range(power(range(large, large), 2, true), large, unbounded);
    expect_range(range(large, large) + range(large, large), large, unbounded);
}

TEST_F(IntervalCases, WavesMeetTheirExtremes) {
    expect_range(sin(range(1, 2)), -sin(range(1, 2)).neg_lo, 1);
    EXPECT_LT(sin(range(1, 1.5F)).hi, 1.0F);
    EXPECT_EQ(sin(range(4, 5)).neg_lo, 1.0F);
    EXPECT_EQ(cos(range(-1, 1)).hi, 1.0F);
    EXPECT_EQ(cos(range(3, 4)).neg_lo, 1.0F);
    expect_range(sin(range(0, 7)), -1, 1);
    expect_range(sin(range(0x1p30F, 0x1p30F)), -1, 1);
    expect_range(cos(whole_line(0.0F)), -1, 1);
}

TEST_F(IntervalCases, PartialFunctionsKnowTheirDomains) {
    EXPECT_FALSE(sqrt(range(-2, -1)).defined);
    EXPECT_TRUE(sqrt(range(-2, 0)).defined);
    EXPECT_FALSE(sqrt(range(-1, 1)).continuous);
    EXPECT_TRUE(sqrt(range(0, 1)).continuous);
    EXPECT_FALSE(log(range(-1, 0)).defined);
    EXPECT_FALSE(log(range(0, 1)).continuous);
    EXPECT_TRUE(log(range(1e-45F, 1)).continuous);
    EXPECT_FALSE(acos(range(1.5F, 2)).defined);
    EXPECT_TRUE(acos(range(1, 2)).defined);
    EXPECT_TRUE(acos(range(-1, 1)).continuous);
    EXPECT_FALSE(acos(range(-1, 1.0000001F)).continuous);
    EXPECT_EQ(log(range(0, 1)).value.neg_lo, unbounded);
}

TEST_F(IntervalCases, AnglesKnowTheCut) {
    EXPECT_FALSE(atan2(range(-1, 1), range(-2, -1)).continuous);
    EXPECT_TRUE(atan2(range(-1, 1), range(1, 2)).continuous);
    EXPECT_TRUE(atan2(range(1, 2), range(-1, 1)).continuous);
    EXPECT_FALSE(atan2(range(0, 0), range(0, 0)).continuous);
    EXPECT_TRUE(angle(range(-1, 1), range(-2, -1)).continuous);
    EXPECT_FALSE(angle(range(-1, 1), range(-2, 0)).continuous);
    const Range turned = angle(range(-1, 1), range(-2, -1)).value;
    EXPECT_NEAR(-turned.neg_lo, 0.75F * static_cast<float>(std::numbers::pi), 1e-5F);
    EXPECT_NEAR(turned.hi, 1.25F * static_cast<float>(std::numbers::pi), 1e-5F);
}

TEST_F(IntervalCases, ExponentialsAreNeverNegative) {
    EXPECT_LE(exp(range(-1000, -900)).neg_lo, 0.0F);
    EXPECT_EQ(exp(range(0, 1000)).hi, unbounded);
    EXPECT_LE(exp(range(1000, 1000)).neg_lo, -1e38F);
    expect_range(exp(whole_line(0.0F)), 0, unbounded);
}

}  // namespace
}  // namespace zeroset
