#include "tests/support/mpfr_number.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/oracle/mpfi_evaluator.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Checks of MPFI's enclosures against point values of MPFR, operator by operator.

namespace zeroset::test::mpfi_test {
namespace {

constexpr mpfr_prec_t bits = 160;

using Box = std::array<Interval<double>, 4>;

std::vector<MpfiInterval> intervals(const Box& box) {
    std::vector<MpfiInterval> result;
    for (const Interval<double>& side : box) {
        const double largest = std::numeric_limits<double>::max();
        result.emplace_back(std::max(-side.neg_lo, -largest), std::min(side.hi, largest));
    }
    return result;
}

std::string claimed(const MpfiEnclosure& f) {
    return f.range.text() + (f.somewhere ? "" : ", nowhere defined") +
           (f.everywhere ? ", defined" : "") + (f.continuous ? ", continuous" : "");
}

class MpfiOperator : public ::testing::TestWithParam<OpInfo> {
protected:
    static Expr formula(RandomNumbers& random) {
        return operator_on_variables(GetParam(), 2 * random.between(1, 4) + 1);
    }
};

TEST_P(MpfiOperator, EnclosesTheValuesOfMpfr) {
    const WorkingPrecision precision(bits);
    RandomNumbers random(static_cast<std::uint64_t>(GetParam().op));
    int defined = 0;
    for (int i = 0; i < 300; ++i) {
        const Expr expr = formula(random);
        Box box{};
        for (Interval<double>& side : box)
            side = random.interval<double>();
        const MpfiEnclosure f = MpfiEvaluator(expr).over(intervals(box));
        std::array<double, 4> at{};
        for (std::size_t v = 0; v < at.size(); ++v)
            at.at(v) = random.point_in(box.at(v));
        const Reference truth = reference(expr, at);
        if (truth.defined && !truth.value.is_finite()) continue;
        SCOPED_TRACE(expr.canonical() + " at " + truth.value.text() + ": " + claimed(f));
        if (!truth.defined) {
            ASSERT_FALSE(f.everywhere);
            continue;
        }
        ++defined;
        ASSERT_TRUE(f.somewhere);
        // Allow for the rounding of the reference, to nearest in 256 bits.
        const MpfrNumber error = truth.value * MpfrNumber(0x1p-250);
        const MpfrNumber above = truth.value.sign() < 0 ? truth.value - error : truth.value + error;
        const MpfrNumber below = truth.value.sign() < 0 ? truth.value + error : truth.value - error;
        const bool enclosed = mpfr_lessequal_p(f.range.lo(), above.get()) != 0 &&
                              mpfr_greaterequal_p(f.range.hi(), below.get()) != 0;
        // Angle is known only up to a turn.
        ASSERT_TRUE(enclosed || GetParam().op == Op::Angle);
    }
    EXPECT_GT(defined, 20);
}

TEST_P(MpfiOperator, IsTightAtPoints) {
    const WorkingPrecision precision(bits);
    RandomNumbers random(77 + static_cast<std::uint64_t>(GetParam().op));
    for (int i = 0; i < 100; ++i) {
        const Expr expr = formula(random);
        const std::array at{random.uniform(0.1, 0.9), random.uniform(0.1, 0.9),
                            random.uniform(0.1, 0.9), 0.0};
        const MpfiEnclosure f = MpfiEvaluator(expr).over(points(at));
        if (!f.somewhere) continue;
        EXPECT_TRUE(f.everywhere && f.continuous) << claimed(f);
        EXPECT_LE(f.range.upper() - f.range.lower(), 1e-15 * (1 + std::abs(f.range.upper())));
    }
}

TEST_P(MpfiOperator, EnclosesTheSlopesOfSecants) {
    const WorkingPrecision precision(bits);
    RandomNumbers random(99 + static_cast<std::uint64_t>(GetParam().op));
    int proved = 0;
    for (int i = 0; i < 400; ++i) {
        const Expr expr = formula(random);
        const double length = std::exp2(random.uniform(-12, 0));
        const MpfiInterval t(0, length);
        std::vector<MpfiDual> line;
        std::vector<double> start;
        std::vector<double> step;
        for (int v = 0; v < 4; ++v) {
            start.push_back(random.uniform(-1.5, 1.5));
            step.push_back(random.uniform(-1, 1));
            const MpfiInterval slope(step.back());
            line.push_back(dual(MpfiInterval(start.back()) + slope * t, slope));
        }
        const MpfiDual f = MpfiEvaluator(expr).along(line);
        if (!f.value.everywhere || !f.value.continuous) continue;
        ++proved;
        std::array<double, 2> at{random.uniform(0, length), random.uniform(0, length)};
        if (at[0] == at[1]) continue;
        std::array<MpfiInterval, 2> value;
        for (std::size_t k = 0; k < 2; ++k) {
            std::vector<MpfiInterval> place;
            for (std::size_t v = 0; v < 4; ++v)
                place.push_back(MpfiInterval(start[v]) +
                                MpfiInterval(step[v]) * MpfiInterval(at.at(k)));
            value.at(k) = MpfiEvaluator(expr).over(place).range;
        }
        const MpfiInterval run = MpfiInterval(at[1]) - MpfiInterval(at[0]);
        const MpfiInterval rise = value[1] - value[0];
        const bool turned = GetParam().op == Op::Angle && (rise.is_above(6) || rise.is_below(-6));
        if (turned) continue;
        const MpfiInterval secant = rise / run;
        EXPECT_TRUE(mpfr_lessequal_p(f.slope.lo(), secant.hi()) != 0 &&
                    mpfr_greaterequal_p(f.slope.hi(), secant.lo()) != 0)
            << expr.canonical() << ": " << secant.text() << " in " << f.slope.text();
    }
    EXPECT_GT(proved, 20);
}

INSTANTIATE_TEST_SUITE_P(Op, MpfiOperator, ::testing::ValuesIn(operators()),
                         [](const auto& row) { return op_name(row); });

}  // namespace
}  // namespace zeroset::test::mpfi_test
