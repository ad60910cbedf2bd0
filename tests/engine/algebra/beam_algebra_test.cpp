#include "engine/algebra/beam_algebra.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/op_names.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

// How tight beam forms are. That they hold is tested against MPFI (tests/oracle).

namespace zeroset::beam_algebra_test {
namespace {

using Form = BeamValue<double>;

/// The variable c + d t with the slope 1, as if t were the third variable of a cell.
Form variable(double c, double d) {
    const double size = std::abs(c) + std::abs(d);
    return {{{c, {std::nullopt, std::nullopt, d}, 0.0}, size, size},
            SlopeBeam<double>{{1.0, {}, 0.0}, 1.0}};
}

/// An operator's form over variables near these middles.
Form form_of(Op op, const std::array<double, 2>& middles, double d, int number = 0) {
    const UpwardRounding upward;
    BeamAlgebra<double> algebra;
    const Form x = variable(middles[0], d);
    const Form y = variable(middles[1], d);
    const Facts facts{};
    return apply(algebra, Node{.op = op, .number = number}, {x, facts}, {y, facts}, {x, facts});
}

/// Functions that are smooth near 0.3 and 0.6, or a little above 1.
class SmoothOperator : public ::testing::TestWithParam<Op> {
protected:
    static std::array<double, 2> middles() {
        const double shift = GetParam() == Op::Acosh ? 1.0 : 0.0;
        return {0.3 + shift, 0.6};
    }
};

/// The error falls with the square of the cell's size, that of the slope, too.
TEST_P(SmoothOperator, FormAndSlopeAreOfSecondOrder) {
    const Form coarse = form_of(GetParam(), middles(), 0x1p-6, 3);
    const Form fine = form_of(GetParam(), middles(), 0x1p-8, 3);
    EXPECT_GT(std::abs(*fine.f.f.k[2]), 0.0);
    EXPECT_LT(fine.f.f.e, coarse.f.f.e / 14);
    EXPECT_LT(fine.slope->f.e, coarse.slope->f.e / 14 + 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Algebra, SmoothOperator,
                         ::testing::Values(Op::Divide, Op::OddRoot, Op::Sqrt, Op::Exp, Op::Log,
                                           Op::Log10, Op::Log2, Op::Sin, Op::Cos, Op::Tan, Op::Cot,
                                           Op::Asin, Op::Acos, Op::Atan, Op::Atan2, Op::Angle,
                                           Op::AngleSin, Op::AngleCos, Op::Length, Op::Sinh,
                                           Op::Cosh, Op::Tanh, Op::Asinh, Op::Acosh, Op::Atanh),
                         [](const auto& op) { return std::string(op_info(op.param).name); });

/// The operands change differently: where they change alike, ln(e^x + e^y) does, too.
class BlendedOperands : public ::testing::TestWithParam<Op> {};

TEST_P(BlendedOperands, FormAndSlopeAreOfSecondOrder) {
    const auto form = [](double d) {
        const UpwardRounding upward;
        BeamAlgebra<double> algebra;
        const Facts facts{};
        const Form x = variable(0.3, d);
        Form y = variable(0.6, -0.5 * d);
        y.slope->f.c = -0.5;
        return apply(algebra, Node{.op = GetParam()}, {x, facts}, {y, facts}, {x, facts});
    };
    const Form coarse = form(0x1p-6);
    const Form fine = form(0x1p-8);
    EXPECT_GT(std::abs(*fine.f.f.k[2]), 0.0);
    EXPECT_GT(coarse.f.f.e, 1e-6);
    EXPECT_LT(fine.f.f.e, coarse.f.f.e / 14);
    EXPECT_LT(fine.slope->f.e, coarse.slope->f.e / 14 + 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Algebra, BlendedOperands, ::testing::Values(Op::LogSum, Op::SmoothMin),
                         [](const auto& op) { return std::string(op_info(op.param).name); });

/// It lies by no more than the width below the least operand, however many there are.
TEST(SmoothMinimum, OfManyOperandsStaysNearTheLeast) {
    const UpwardRounding upward;
    BeamAlgebra<double> algebra;
    const Facts facts{};
    Form least = variable(0.0, 3.0);
    for (int i = 0; i < 1000; ++i) {
        const Form next = variable(0.01 * (i % 7), i % 2 == 0 ? 3.0 : -3.0);
        least = apply(algebra, Node{.op = Op::SmoothMin}, {least, facts}, {next, facts},
                      {least, facts});
    }
    EXPECT_LE(least.f.range().neg_lo, 4.0 + 1e-9);
    EXPECT_GE(least.f.range().neg_lo, 3.0);
    EXPECT_LE(least.f.range().hi, 3.1);
}

/// Quotients where they are used: for operands near 0.
TEST(BeamForm, OfSineOverItsOperandIsOfSecondOrderNearZero) {
    for (const Op op : {Op::Sinc, Op::Sinhc, Op::Atanc}) {
        const Form coarse = form_of(op, {0x1p-8, 0}, 0x1p-8, 3);
        const Form fine = form_of(op, {0x1p-10, 0}, 0x1p-10, 3);
        EXPECT_LT(coarse.f.f.e, 0x1p-16);
        EXPECT_LT(fine.f.f.e, coarse.f.f.e / 14);
        EXPECT_LT(fine.slope->f.e, coarse.slope->f.e / 3);
    }
}

/// A tangent whose error lies on one side has half of it in the middle.
TEST(BeamForm, OfACurveBentOneWayHasAQuarterOfTheSquare) {
    const double d = 0x1p-10;
    const double c = 0.5;
    const double unit = 0.25 * d * d;
    EXPECT_NEAR(form_of(Op::Exp, {c, 0}, d).f.f.e / unit, std::exp(c), 0.01);
    EXPECT_NEAR(form_of(Op::Log, {c, 0}, d).f.f.e / unit, 1 / (c * c), 0.02);
    EXPECT_NEAR(form_of(Op::Sin, {c, 0}, d).f.f.e / unit, std::sin(c), 0.01);
    EXPECT_NEAR(form_of(Op::Cosh, {c, 0}, d).f.f.e / unit, std::cosh(c), 0.01);
}

/// y = c + d t, x = 0.3 + d t: |second derivative| is 1 / rho^2.
TEST(BeamForm, OfAnAngleIsBoundedByTheDistance) {
    const double d = 0x1p-10;
    for (const Op op : {Op::Atan2, Op::Angle}) {
        const Form angle = form_of(op, {0.4, 0.3}, d);
        EXPECT_NEAR(angle.f.f.c, std::atan2(0.4, 0.3), 1e-12);
        EXPECT_NEAR(angle.f.f.e / (d * d), 1 / (0.3 * 0.3 + 0.4 * 0.4), 0.1);
    }
}

TEST(BeamForm, OfAnAngleDoesNotCrossTheCut) {
    const Form cut = form_of(Op::Atan2, {0.0, -0.5}, 0x1p-6);
    EXPECT_FALSE(*cut.continuous);
    EXPECT_GE(cut.f.range().hi, 3.1415);
    EXPECT_GE(cut.f.range().neg_lo, 3.1415);
    const Form angle = form_of(Op::Angle, {0.0, -0.5}, 0x1p-6);
    EXPECT_TRUE(*angle.continuous);
    EXPECT_LT(angle.f.f.e, 0.01);
}

/// sin(n angle) bends by n^2 sin / rho^2 at most; a length by 1 / rho.
TEST(BeamForm, OfAWaveIsBoundedByTheSquareOfItsFactor) {
    const double d = 0x1p-10;
    const int n = 6;
    const double angle = std::numbers::pi / 12;  // a crest
    const std::array middles{0.5 * std::sin(angle), 0.5 * std::cos(angle)};
    const Form wave = form_of(Op::AngleSin, middles, d, n);
    const double across = std::abs(std::cos(angle) - std::sin(angle)) * d / 0.5;
    EXPECT_NEAR(wave.f.f.c, 1.0, n * n * across * across);
    EXPECT_NEAR(wave.f.f.e, 0.25 * n * n * across * across, 0.01 * wave.f.f.e);
    const Form length = form_of(Op::Length, middles, d);
    EXPECT_NEAR(length.f.f.c, 0.5, d * d);
    EXPECT_NEAR(length.f.f.e, 0.25 * 0.5 * across * across, 0.01 * length.f.f.e);
}

TEST(BeamForm, OfAWaveBesideTheOriginIsItsRange) {
    const Form wave = form_of(Op::AngleCos, {0.01, 0.02}, 0x1p-4, 3);
    EXPECT_FALSE(*wave.continuous);
    EXPECT_NEAR(wave.f.range().neg_lo, 1.0, 1e-14);
    EXPECT_NEAR(wave.f.range().hi, 1.0, 1e-14);
    const Form length = form_of(Op::Length, {0.01, 0.02}, 0x1p-4);
    EXPECT_FALSE(length.continuous.has_value());
    EXPECT_LE(length.f.range().hi, 1.1 * std::hypot(0.01 + 0x1p-4, 0.02 + 0x1p-4));
    EXPECT_GE(length.slope->range().hi, std::numbers::sqrt2);
}

/// Nothing is known of the rounding where one operand's is unknown, as of a quotient that
/// overflows, whichever operand is taken.
TEST(BeamForm, OfTheLargerKeepsUnknownRoundings) {
    const UpwardRounding upward;
    BeamAlgebra<double> algebra;
    const Facts facts{};
    const Form known = variable(0.5, 0.25);
    Form unknown = variable(-3.0, 0.25);
    unknown.f.r = std::numeric_limits<double>::quiet_NaN();
    for (const Op op : {Op::Min, Op::Max}) {
        const Node node{.op = op};
        for (const auto& [a, b] : {std::pair(known, unknown), std::pair(unknown, known)}) {
            const Form larger = apply(algebra, node, {a, facts}, {b, facts}, {a, facts});
            EXPECT_EQ(larger.f.r, std::numeric_limits<double>::infinity()) << op_info(op).name;
        }
    }
}

/// No member of a form may be a number where nothing is known.
TEST(BeamForm, OfTheReciprocalOfAHalfLineIsUnknown) {
    const UpwardRounding upward;
    BeamAlgebra<double> algebra;
    const Facts facts{};
    const double most = std::numeric_limits<double>::max();
    const Form one{{{1.0, {}, 0.0}, 1.0, 1.0}};
    const Form large{{{most, {}, 0.0}, most, most}};  // its range, widened, has no end
    ASSERT_EQ(large.f.range().hi, std::numeric_limits<double>::infinity());
    const Form quotient =
        apply(algebra, Node{.op = Op::Divide}, {one, facts}, {large, facts}, {one, facts});
    EXPECT_GE(quotient.f.range().hi, 1.0 / most);
}

TEST(BeamForm, OfALengthKnowsWhereItsSquareIsLost) {
    const UpwardRounding upward;
    BeamAlgebra<double> algebra;
    const Facts facts{};
    const auto length = [&](double y, double x) {
        const Form of_y{{{y, {}, 0.0}, y, y}};
        const Form of_x{{{x, {}, 0.0}, x, x}};
        return apply(algebra, Node{.op = Op::Length}, {of_y, facts}, {of_x, facts}, {of_x, facts});
    };
    EXPECT_EQ(length(1e200, 1.0).f.r, std::numeric_limits<double>::infinity());
    const double error = std::numeric_limits<double>::epsilon() * length(1e-170, 1e-170).f.r;
    EXPECT_GE(error, 1e-170);
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(length(1.0, unknown).f.range().hi, std::numeric_limits<double>::infinity());
    EXPECT_EQ(length(unknown, 1.0).f.range().hi, std::numeric_limits<double>::infinity());
}

/// Between the slopes 1 and 0.
TEST(BeamForm, OfTheLargerHasASlopeOfEitherSize) {
    const UpwardRounding upward;
    BeamAlgebra<double> algebra;
    const Facts facts{};
    const Form sloped = variable(0.1, 0.25);
    const Form level{{{0.0, {}, 0.0}, 0.0, 0.0}};
    for (const Op op : {Op::Min, Op::Max}) {
        const Node node{.op = op};
        for (const auto& [a, b] : {std::pair(sloped, level), std::pair(level, sloped)}) {
            const Form larger = apply(algebra, node, {a, facts}, {b, facts}, {a, facts});
            EXPECT_GE(larger.slope->range().hi, 1.0) << op_info(op).name;
            EXPECT_GE(larger.slope->range().neg_lo, 0.0) << op_info(op).name;
            EXPECT_GE(larger.slope->size, 1.0) << op_info(op).name;
        }
    }
}

TEST(BeamForm, OfTheOrientedTakesTheSignOfTheDivisor) {
    const double d = 0x1p-4;
    const Form above = form_of(Op::Oriented, {0.7, 0.5}, d);
    EXPECT_EQ(above.zeros->f.c, 0.7);
    EXPECT_EQ(*above.zeros->f.k[2], d);
    EXPECT_TRUE(*above.everywhere);
    const Form below = form_of(Op::Oriented, {0.7, -0.5}, d);
    EXPECT_EQ(below.f.f.c, -0.7);
    EXPECT_NEAR(below.slope->range().hi, -1.0, 1e-14);
    EXPECT_TRUE(*below.everywhere);
    const Form unknown = form_of(Op::Oriented, {0.7, 0.0}, d);
    EXPECT_FALSE(*unknown.everywhere);
    EXPECT_EQ(unknown.zeros->f.c, 0.7);  // no zero there, whatever the sign
    EXPECT_GE(unknown.f.range().neg_lo, 0.7);
    EXPECT_GE(unknown.f.range().hi, 0.7);
    EXPECT_GE(unknown.slope->range().neg_lo, 1.0);
    EXPECT_GE(unknown.slope->range().hi, 1.0);
}

}  // namespace
}  // namespace zeroset::beam_algebra_test
