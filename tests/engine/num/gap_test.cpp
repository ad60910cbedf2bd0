#include "engine/num/elementary.hpp"
#include "engine/num/enclosure.hpp"
#include "engine/num/periodic.hpp"
#include "engine/num/steps.hpp"
#include "engine/real/rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// The two sides of a jump or a pole: what lies between them is no value. That they hold is checked
// in tests/property; here, that they are as far apart as they are.

namespace zeroset::gap_test {
namespace {

using Range = Interval<float>;

Range range(float lo, float hi) { return {-lo, hi}; }

class GapCases : public ::testing::Test {
protected:
    /// Values are at most `below` or at least `above`.
    static void expect_sides(const std::optional<Range>& gap, double below, double above,
                             double error = 0.0) {
        ASSERT_TRUE(gap.has_value());
        EXPECT_NEAR(static_cast<double>(gap->hi), below, error);
        EXPECT_NEAR(-static_cast<double>(gap->neg_lo), above, error);
    }
    static void expect_nothing(const std::optional<Range>& gap) {
        ASSERT_TRUE(gap.has_value());
        EXPECT_EQ(gap->hi, static_cast<float>(infinity));
        EXPECT_EQ(gap->neg_lo, static_cast<float>(infinity));
    }

    static Enclosure<float> remainder(const Range& a, const Range& b) {
        return mod(a, b, floor_steps(a / b));
    }
    static Enclosure<float> angle_of(const Range& y, const Range& x) {
        return atan2(y, x, angle_sides(y, x));
    }

private:
    UpwardRounding upward_;
};

TEST_F(GapCases, StepsHaveNoValueBetweenNeighbours) {
    expect_sides(jumping(floor_steps(range(0.5F, 1.5F))).gap, 0, 1);
    expect_sides(jumping(ceil_steps(range(0.5F, 1.5F))).gap, 1, 2);
    expect_sides(jumping(round_steps(range(-0.7F, 0.2F))).gap, -1, 0);
    expect_sides(jumping(sign_steps(range(0, 2))).gap, 0, 1);
    expect_nothing(jumping(floor_steps(range(0.5F, 2.5F))).gap);
    expect_nothing(jumping(sign_steps(range(-1, 1))).gap);
}

TEST_F(GapCases, RemaindersJumpByTheDivisor) {
    expect_sides(remainder(range(0.75F, 1.25F), range(1, 1)).gap, 0.25, 0.75);
    expect_sides(remainder(range(3.5F, 4.5F), range(2, 2)).gap, 0.5, 1.5);
    expect_nothing(remainder(range(0.75F, 2.25F), range(1, 1)).gap);
    expect_nothing(remainder(range(1, 2), range(-1, 1)).gap);
}

TEST_F(GapCases, QuotientsAreLargeBesideAPole) {
    expect_sides(quotient_gap(range(1, 2), range(-0.5F, 0.25F)), -2, 4);
    expect_sides(quotient_gap(range(-2, -1), range(-0.5F, 0.25F)), -4, 2);
    expect_nothing(quotient_gap(range(-1, 2), range(-0.5F, 0.25F)));
    expect_nothing(quotient_gap(range(1, 2), range(0.25F, 0.5F)));
}

TEST_F(GapCases, TangentsAreLargeBesideAPole) {
    const auto pole = static_cast<float>(0.5 * std::numbers::pi);
    const float step = 0.25F;
    const double cot_step = 1.0 / std::tan(0.25);
    expect_sides(tan(range(pole - step, pole + step)).gap, -cot_step, cot_step, 1e-5);
    expect_sides(cot(range(-step, step)).gap, -cot_step, cot_step, 1e-5);
    expect_nothing(tan(range(pole - step, pole + 3)).gap);
    // With the pole at an end there is nothing on its other side.
    EXPECT_LT(cot(range(0, step)).gap->hi, -1e37F);
    EXPECT_LT(cot(range(-step, 0)).gap->neg_lo, -1e37F);
}

TEST_F(GapCases, AnglesAreAWholeTurnApartAtTheCut) {
    const double least = std::atan2(0.5, -1.0);
    expect_sides(angle_of(range(-0.5F, 0.5F), range(-2, -1)).gap, -least, least, 1e-5);
    for (const float zero : {0.0F, -0.0F}) {
        const Range above = *angle_of(range(zero, 0.5F), range(-2, -1)).gap;
        expect_sides(above, -std::numbers::pi, least, 1e-5);
        const Range below = *angle_of(Range{0.5F, zero}, range(-2, -1)).gap;
        expect_sides(below, -least, std::numbers::pi, 1e-5);
    }
    expect_nothing(angle_of(range(-0.5F, 0.5F), range(-2, 1)).gap);
}

TEST_F(GapCases, ChoicesTakeOneSideOrTheOther) {
    const Enclosure<float> open{range(0, 1)};
    const Enclosure<float> low{range(-3, -2)};
    const Enclosure<float> high{range(5, 6)};
    expect_sides(choose(open, low, high).gap, -2, 5);
    expect_sides(choose(open, high, low).gap, -2, 5);
    expect_nothing(choose(Enclosure<float>{range(1, 1)}, low, high).gap);
}

TEST_F(GapCases, MultiplesKeepTheSides) {
    const Range gap = range(4, -2);  // at most -2 or at least 4
    expect_sides(multiply_gap(gap, range(2, 3)), -4, 8);
    expect_sides(multiply_gap(gap, range(-3, -2)), -8, 4);
    expect_nothing(multiply_gap(gap, range(-1, 1)));
}

TEST_F(GapCases, AnswersLeaveOutZero) {
    const Range two_sides = answer(Enclosure<float>{range(-9, 9), {}, {}, {}, range(4, -2)});
    EXPECT_EQ(two_sides.hi, -2.0F);
    EXPECT_EQ(two_sides.neg_lo, -4.0F);
    const Range one = answer(Enclosure<float>{range(-9, 9), {}, {}, {}, range(4, 2)});
    EXPECT_EQ(one.hi, 9.0F);
    EXPECT_EQ(one.neg_lo, 9.0F);
}

}  // namespace
}  // namespace zeroset::gap_test
