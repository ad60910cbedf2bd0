#include "engine/num/interval.hpp"

#include "engine/num/odd_root.hpp"
#include "engine/num/periodic.hpp"
#include "engine/num/steps.hpp"
#include "engine/real/rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

// Hand-picked cases in which the enclosure is known exactly. tests/property checks that the
// functions enclose at all.

namespace zeroset::interval_test {
namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();
using Range = Interval<float>;

Range range(float lo, float hi) { return {-lo, hi}; }

Enclosure<float> log(const Range& a) { return logarithm(Elementary::Log, a); }

void expect_range(const Range& found, float lo, float hi) {
    EXPECT_EQ(-found.neg_lo, lo);
    EXPECT_EQ(found.hi, hi);
}

class IntervalCases : public ::testing::Test {
protected:
    static Enclosure<float> remainder(const Range& a, const Range& b) {
        return mod(a, b, floor_steps(a / b));
    }
    static Enclosure<float> angle_of(const Range& y, const Range& x) {
        return atan2(y, x, angle_sides(y, x));
    }

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
    EXPECT_FALSE(*sqrt(range(-2, -1)).somewhere);
    EXPECT_TRUE(*sqrt(range(-2, 0)).somewhere);
    EXPECT_FALSE(*sqrt(range(-1, 1)).everywhere);
    EXPECT_TRUE(*sqrt(range(0, 1)).everywhere);
    EXPECT_FALSE(*log(range(-1, 0)).somewhere);
    EXPECT_FALSE(*log(range(0, 1)).everywhere);
    EXPECT_TRUE(*log(range(1e-45F, 1)).everywhere);
    EXPECT_FALSE(*acos(range(1.5F, 2)).somewhere);
    EXPECT_TRUE(*acos(range(1, 2)).somewhere);
    EXPECT_TRUE(*acos(range(-1, 1)).everywhere);
    EXPECT_FALSE(*acos(range(-1, 1.0000001F)).everywhere);
    EXPECT_EQ(log(range(0, 1)).range.neg_lo, unbounded);
    EXPECT_TRUE(*acosh(range(0, 1)).somewhere);
    EXPECT_FALSE(*acosh(range(0, 0.5F)).somewhere);
    EXPECT_FALSE(*acosh(range(0.5F, 2)).everywhere);
    EXPECT_FALSE(*atanh(range(1, 2)).somewhere);
    EXPECT_FALSE(*atanh(range(0, 1)).everywhere);
    EXPECT_TRUE(*atanh(range(-0.5F, 0.5F)).everywhere);
    EXPECT_FALSE(*asin(range(1.5F, 2)).somewhere);
    EXPECT_TRUE(*asin(range(-1, 1)).everywhere);
}

TEST_F(IntervalCases, AnglesKnowTheCut) {
    EXPECT_FALSE(*angle_of(range(-1, 1), range(-2, -1)).continuous);
    EXPECT_TRUE(*angle_of(range(-1, 1), range(-2, -1)).everywhere);
    EXPECT_FALSE(*angle_of(range(-1, 1), range(-2, 1)).everywhere);
    EXPECT_TRUE(*angle_of(range(-1, 1), range(1, 2)).continuous);
    EXPECT_TRUE(*angle_of(range(1, 2), range(-1, 1)).continuous);
    EXPECT_FALSE(*angle_of(range(0, 0), range(0, 0)).continuous);
    EXPECT_TRUE(*angle(range(-1, 1), range(-2, -1)).continuous);
    EXPECT_FALSE(*angle(range(-1, 1), range(-2, 0)).continuous);
    const Range turned = angle(range(-1, 1), range(-2, -1)).range;
    EXPECT_NEAR(-turned.neg_lo, 0.75F * static_cast<float>(std::numbers::pi), 1e-5F);
    EXPECT_NEAR(turned.hi, 1.25F * static_cast<float>(std::numbers::pi), 1e-5F);
}

TEST_F(IntervalCases, ExponentialsAreNeverNegative) {
    EXPECT_LE(exp(range(-1000, -900)).neg_lo, 0.0F);
    EXPECT_EQ(exp(range(0, 1000)).hi, unbounded);
    EXPECT_LE(exp(range(1000, 1000)).neg_lo, -1e38F);
    expect_range(exp(whole_line(0.0F)), 0, unbounded);
}

TEST_F(IntervalCases, TangentsKnowTheirPoles) {
    EXPECT_TRUE(*tan(range(-1.5F, 1.5F)).everywhere);
    EXPECT_NEAR(tan(range(-1.5F, 1.5F)).range.hi, std::tan(1.5), 1e-4);
    EXPECT_FALSE(*tan(range(1.5F, 1.6F)).everywhere);
    expect_range(tan(range(1.5F, 1.6F)).range, -unbounded, unbounded);
    EXPECT_TRUE(*tan(range(1.6F, 4.7F)).everywhere);
    EXPECT_FALSE(tan(range(1.5F, 1.6F)).continuous.has_value());
    EXPECT_TRUE(*cot(range(0.1F, 3.1F)).everywhere);
    EXPECT_LT(cot(range(0.1F, 3.1F)).range.hi, 9.97F);
    EXPECT_GT(cot(range(0.1F, 3.1F)).range.hi, 9.96F);
    EXPECT_FALSE(*cot(range(-0.1F, 0.1F)).everywhere);
    EXPECT_FALSE(*cot(range(3, 4)).everywhere);
    EXPECT_FALSE(*tan(whole_line(0.0F)).everywhere);
}

TEST_F(IntervalCases, HyperbolicsKnowTheirMinimaAndLimits) {
    expect_range(cosh(range(-1, 1)), 1, cosh(range(0, 1)).hi);
    expect_range(cosh(whole_line(0.0F)), 1, unbounded);
    expect_range(tanh(whole_line(0.0F)), -1, 1);
    const Range large = odd_increasing(Elementary::Sinh, range(89, 89));
    EXPECT_GT(large.hi, 2.2e38F);
    EXPECT_LE(-large.neg_lo, 2.2e38F);
    EXPECT_GT(-large.neg_lo, 1e37F);
    const Range far = odd_increasing(Elementary::Asinh, range(-unbounded, -1e30F));
    EXPECT_LE(far.hi, -43.0F);
    EXPECT_EQ(far.neg_lo, unbounded);
    EXPECT_GE(-acosh(range(1e30F, 1e30F)).range.neg_lo, 43.0F);
}

TEST_F(IntervalCases, StepsAreExact) {
    expect_range(floor_steps(range(-1.5F, 2.5F)), -2, 2);
    expect_range(ceil_steps(range(-1.5F, 2.5F)), -1, 3);
    expect_range(round_steps(range(-1.5F, 2.5F)), -1, 3);
    expect_range(round_steps(range(0x1.fffffep-2F, 0x1.fffffep-2F)), 0, 0);
    expect_range(round_steps(range(-0.5F, -1e-30F)), 0, 0);
    expect_range(round_steps(range(-0x1.000002p-1F, 0)), -1, 0);
    expect_range(round_steps(range(8388609, 8388609)), 8388609, 8388609);
    expect_range(sign_steps(range(-2, 0)), -1, 0);
    expect_range(sign_steps(range(1e-45F, unbounded)), 1, 1);
    expect_range(floor_steps(whole_line(0.0F)), -unbounded, unbounded);
}

TEST_F(IntervalCases, StepsAreContinuousBetweenRisers) {
    EXPECT_TRUE(*jumping(floor_steps(range(2, 2.9F))).continuous);
    EXPECT_FALSE(*jumping(floor_steps(range(2.9F, 3))).continuous);
    EXPECT_TRUE(*jumping(ceil_steps(range(2.1F, 3))).continuous);
    EXPECT_FALSE(*jumping(ceil_steps(range(3, 3.1F))).continuous);
    EXPECT_FALSE(*jumping(round_steps(range(2.4F, 2.5F))).continuous);
    EXPECT_TRUE(*jumping(round_steps(range(2.5F, 3.4F))).continuous);
    EXPECT_FALSE(*jumping(sign_steps(range(0, 1))).continuous);
    EXPECT_FALSE(*jumping(floor_steps(whole_line(0.0F))).continuous);
}

TEST_F(IntervalCases, RemaindersKnowTheirStep) {
    expect_range(remainder(range(3, 3.5F), range(2, 2)).range, 1, 1.5F);
    expect_range(remainder(range(-3, -2.5F), range(2, 2)).range, 1, 1.5F);
    expect_range(remainder(range(2.5F, 3), range(-2, -2)).range, -1.5F, -1);
    EXPECT_TRUE(*remainder(range(3, 3.5F), range(2, 2)).continuous);
    expect_range(remainder(range(3, 4), range(2, 2)).range, 0, 2);
    EXPECT_FALSE(*remainder(range(3, 4), range(2, 2)).continuous);
    expect_range(remainder(range(-100, 100), range(-2, 3)).range, -2, 3);
    EXPECT_FALSE(*remainder(range(1, 2), range(0, 3)).everywhere);
    EXPECT_TRUE(*remainder(range(1, 9), range(2, 3)).everywhere);
    expect_range(remainder(whole_line(0.0F), range(0.5F, 0.5F)).range, 0, 0.5F);
}

/// Width of the interval in ulp of its upper end.
float width(const Range& a) { return (a.hi + a.neg_lo) / (std::abs(a.hi) * 0x1p-23F); }

TEST_F(IntervalCases, OddRootsAreNarrow) {
    for (const int n : {3, 5, 7, 9, 11, 101, 10001}) {
        for (const float a : {1e-30F, 0.3F, 1.0F, 7.0F, 1e30F}) {
            EXPECT_LE(width(odd_root(point(a), n)), 12) << n << " of " << a;
            EXPECT_LE(width(odd_root(point(-a), n)), 12) << n << " of " << -a;
        }
        EXPECT_GE(odd_root(range(-1, 1), n).hi, 1.0F);
        expect_range(odd_root(range(0, 0), n), 0, 0);
        expect_range(odd_root(whole_line(0.0F), n), -unbounded, unbounded);
    }
    EXPECT_NEAR(odd_root(range(-32, 243), 5).hi, 3.0F, 1e-6F);
    EXPECT_NEAR(odd_root(range(-32, 243), 5).neg_lo, 2.0F, 1e-6F);
}

TEST_F(IntervalCases, ConditionsAreDecidedByTheirEnds) {
    expect_range(less(range(1, 2), range(3, 4)), 1, 1);
    expect_range(less(range(1, 3), range(3, 4)), 0, 1);
    expect_range(less(range(4, 5), range(3, 4)), 0, 0);
    expect_range(less_equal(range(1, 3), range(3, 4)), 1, 1);
    expect_range(less_equal(range(4, 5), range(3, 4)), 0, 1);
    EXPECT_TRUE(*stepped(less(range(1, 2), range(3, 4))).continuous);
    EXPECT_FALSE(*stepped(less(range(1, 3), range(3, 4))).continuous);
}

TEST_F(IntervalCases, ChoicesHaveTheMasksOfWhatTheyTake) {
    const Enclosure<float> holds{range(1, 1)};
    const Enclosure<float> fails{range(0, 0)};
    const Enclosure<float> open{range(0, 1)};
    const Enclosure<float> five{range(5, 5)};
    const Enclosure<float> nothing{range(9, 9), false, false, true};
    const Enclosure<float> jump{range(7, 8), true, true, false};
    expect_range(choose(holds, five, nothing).range, 5, 5);
    EXPECT_TRUE(*choose(holds, five, nothing).everywhere);
    EXPECT_FALSE(*choose(fails, five, nothing).somewhere);
    expect_range(choose(open, five, nothing).range, 5, 5);
    EXPECT_TRUE(*choose(open, five, nothing).somewhere);
    EXPECT_FALSE(*choose(open, five, nothing).everywhere);
    EXPECT_FALSE(*choose(open, nothing, nothing).somewhere);
    expect_range(choose(open, five, jump).range, 5, 8);
    EXPECT_FALSE(*choose(open, five, five).continuous);
    EXPECT_TRUE(*choose(holds, five, jump).continuous);
    EXPECT_FALSE(*choose(fails, five, jump).continuous);
    EXPECT_FALSE(*choose(nothing, five, five).somewhere);
}

TEST_F(IntervalCases, RestrictionsLeaveTheValue) {
    const Enclosure<float> five{range(5, 5)};
    expect_range(where(five, {range(0, 1)}).range, 5, 5);
    EXPECT_TRUE(*where(five, {range(0, 1)}).somewhere);
    EXPECT_FALSE(*where(five, {range(0, 1)}).everywhere);
    EXPECT_FALSE(*where(five, {range(0, 0)}).somewhere);
    EXPECT_TRUE(*where(five, {range(1, 1)}).everywhere);
    EXPECT_FALSE(where(five, {range(0, 1)}).continuous.has_value());
}

}  // namespace
}  // namespace zeroset::interval_test
