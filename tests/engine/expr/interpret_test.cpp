#include "engine/expr/interpret.hpp"

#include "engine/expr/parse.hpp"
#include "engine/num/rounding.hpp"
#include "tests/support/kernel_batch.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_expression.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace zeroset::test {
namespace {

constexpr std::size_t items = batch_multiple;
constexpr float nowhere = -std::numeric_limits<float>::infinity();

struct Answer {
    float lo;
    float hi;
    bool continuous;
};

/// f over the same box [lo, hi] in x, y and z.
Answer range_over(const char* text, float lo, float hi, double w = 0) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr.has_value()) << text;
    const Kernel kernel = interpret(*expr);
    std::array<float, items> neg_los{};
    std::array<float, items> his{};
    neg_los.fill(-lo);
    his.fill(hi);
    std::array<float, items> f_neg_lo{};
    std::array<float, items> f_hi{};
    std::array<std::uint32_t, items> continuous{};
    Uniforms uniforms;
    uniforms.set(0, w);
    const UpwardRounding upward;
    kernel.range({items,
                  {neg_los.data(), neg_los.data(), neg_los.data()},
                  {his.data(), his.data(), his.data()},
                  uniforms.neg_lo_hi.data(),
                  f_neg_lo.data(),
                  f_hi.data(),
                  continuous.data()});
    const bool defined = f_hi[items - 1] != nowhere;
    EXPECT_TRUE(continuous[0] == 0 || continuous[0] == ~0U);
    return {defined ? -f_neg_lo[items - 1] : nowhere, f_hi[items - 1], continuous[0] != 0};
}

TEST(ValueAt, HasTheValuesOfClosedForms) {
    const auto value = [](const char* text, double x, double y) {
        return value_at(*parse(text), {x, y, 0.25, 3}).value;
    };
    EXPECT_EQ(value("x^2 + y^2 - 25", 3, 4), 0);
    EXPECT_EQ(value("x*y - w + z", 2, 5), 7.25);
    EXPECT_EQ(value("sqrt(x)/y", 16, 2), 2);
    EXPECT_EQ(value("abs(x) + min(x, y)", -3, 1), 0);
    EXPECT_EQ(value("atan2(y, x)", -1, 0), std::atan2(0.0, -1.0));
    EXPECT_EQ(value("exp(log(x))", 1, 0), 1);
    EXPECT_TRUE(std::isnan(value("sqrt(x)", -1, 0)));
    EXPECT_TRUE(std::isinf(value("1/x", 0, 0)));
}

TEST(ValueAt, AgreesWithMpfrOnRandomGraphs) {
    RandomNumbers random(50);
    int compared = 0;
    for (int i = 0; i < 3000; ++i) {
        const Expr expr = random_expression(random, 3);
        std::array<double, 4> at{};
        for (double& coordinate : at)
            coordinate = random.uniform(-2, 2);
        const Reference truth = reference(expr, at);
        const double found = value_at(expr, at).value;
        if (!truth.defined || truth.is_unknown()) continue;
        const double expected = truth.value.nearest();
        // Cancellation and poles may lose digits, in a few formulas all of them.
        if (std::abs(found - expected) <= 1e-9 * (1 + std::abs(expected))) ++compared;
    }
    EXPECT_GT(compared, 1500);
}

TEST(Interpret, EnclosesKnownRanges) {
    const Answer sphere = range_over("x^2 + y^2 + z^2 - 1", -1, 2);
    EXPECT_EQ(sphere.lo, -1);
    EXPECT_EQ(sphere.hi, 11);
    EXPECT_TRUE(sphere.continuous);
    const Answer sum = range_over("x + 2*w", 1, 2, 3);
    EXPECT_EQ(sum.lo, 7);
    EXPECT_EQ(sum.hi, 8);
}

TEST(Interpret, SaysWhereNothingIsDefined) {
    EXPECT_EQ(range_over("sqrt(x)", -2, -1).hi, nowhere);
    EXPECT_EQ(range_over("y + log(x)*0", -2, -1).hi, nowhere);
    EXPECT_EQ(range_over("min(sqrt(x), 1)", -2, -1).hi, nowhere);
    EXPECT_FALSE(range_over("sqrt(x)", -2, -1).continuous);
}

TEST(Interpret, SaysWhereContinuityIsProved) {
    EXPECT_TRUE(range_over("1/x", 1, 2).continuous);
    EXPECT_FALSE(range_over("1/x", -1, 2).continuous);
    EXPECT_FALSE(range_over("1/x", 0, 2).continuous);
    EXPECT_FALSE(range_over("sqrt(x) + y", -1, 2).continuous);
    EXPECT_TRUE(range_over("sqrt(x^2) + y", -1, 2).continuous);
    EXPECT_FALSE(range_over("atan2(y + 1.5, x)", -2, -1).continuous);
    EXPECT_TRUE(range_over("sin(3*atan2(y + 1.5, x))", -2, -1).continuous);
    EXPECT_FALSE(range_over("sin(0.5*atan2(y + 1.5, x))", -2, -1).continuous);
}

TEST(Interpret, HasTheValuesOfValueAt) {
    RandomNumbers random(51);
    const auto expr = parse("x^3 - 2.5*x*y + sin(z) - w");
    const KernelBatch batch(random, items);
    const Bits first = batch.run(interpret(*expr));
    EXPECT_EQ(first, batch.run(interpret(*expr)));
    EXPECT_EQ(first.value.size(), 4 * items);
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(Interpret, KnowsWhetherWIsUsed) {
    EXPECT_TRUE(interpret(*parse("x*w")).uses_w);
    EXPECT_FALSE(interpret(*parse("x*y")).uses_w);
    EXPECT_FALSE(Kernel());
    EXPECT_TRUE(interpret(*parse("x")));
}

TEST(Uniforms, EncloseTheirNumber) {
    Uniforms uniforms;
    uniforms.set(1, 0.1, 0.3);
    ASSERT_EQ(uniforms.neg_lo_hi.size(), 4);
    ASSERT_EQ(uniforms.middle.size(), 2);
    EXPECT_LE(-static_cast<double>(uniforms.neg_lo_hi[2]), 0.1);
    EXPECT_GE(static_cast<double>(uniforms.neg_lo_hi[3]), 0.3);
    EXPECT_FLOAT_EQ(uniforms.middle[1], 0.2F);
    uniforms.set(0, 0.5);
    EXPECT_EQ(uniforms.neg_lo_hi[0], -0.5F);
    EXPECT_EQ(uniforms.neg_lo_hi[1], 0.5F);
}

}  // namespace
}  // namespace zeroset::test
