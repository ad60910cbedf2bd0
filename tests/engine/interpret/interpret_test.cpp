#include "engine/interpret/interpret.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/algebra/graph_facts.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/tape/tape.hpp"
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

namespace zeroset::test::interpret_test {
namespace {

constexpr std::size_t items = batch_multiple;
constexpr float nowhere = -std::numeric_limits<float>::infinity();

struct Answer {
    float lo;
    float hi;
    bool continuous;
};

/// f over the same box [lo, hi] in x, y and z.
Answer range_over(const Expr& expr, float lo, float hi, double w = 0) {
    const Kernel kernel = interpret(expr);
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
    kernel.in_float.range({items,
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

Answer range_over(const char* text, float lo, float hi, double w = 0) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr.has_value()) << text;
    return range_over(*expr, lo, hi, w);
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
    EXPECT_EQ(value("exp(ln(x))", 1, 0), 1);
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
    EXPECT_EQ(range_over("y + ln(x)*0", -2, -1).hi, nowhere);
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

/// The graph that `make` builds, over the box [lo, hi] in x, y and z.
template <class Make>
Answer range_of(Make make, float lo, float hi) {
    ExprBuilder builder;
    return range_over(builder.finish(make(builder, builder.variable(0))), lo, hi);
}

/// if(x > 0, ln(x), -1)
NodeId logarithm_above_0(ExprBuilder& builder, NodeId x) {
    const NodeId above = builder.apply(Op::Less, builder.constant(0), x);
    return builder.apply(Op::If, above, builder.apply(Op::Log, x), builder.constant(-1));
}

TEST(Interpret, TakesTheDomainOfTheChosenSideOnly) {
    const Answer above = range_of(logarithm_above_0, 1, 2);
    EXPECT_TRUE(above.continuous);
    EXPECT_NEAR(above.hi, std::log(2.0F), 1e-6F);
    const Answer below = range_of(logarithm_above_0, -2, 0);
    EXPECT_TRUE(below.continuous);
    EXPECT_EQ(below.lo, -1);
    EXPECT_EQ(below.hi, -1);
    const Answer across = range_of(logarithm_above_0, -1, 1);
    EXPECT_FALSE(across.continuous);
    EXPECT_EQ(across.lo, -std::numeric_limits<float>::infinity());
    EXPECT_LT(across.hi, 1e-6F);
}

TEST(Interpret, RestrictsToACondition) {
    const auto restricted = [](ExprBuilder& builder, NodeId x) {
        const NodeId above = builder.apply(Op::LessEqual, builder.constant(1), x);
        return builder.apply(Op::Where, builder.apply(Op::Negate, x), above);
    };
    EXPECT_EQ(range_of(restricted, 0, 0.5F).hi, nowhere);
    EXPECT_FALSE(range_of(restricted, 0, 2).continuous);
    EXPECT_EQ(range_of(restricted, 0, 2).lo, -2);
    EXPECT_TRUE(range_of(restricted, 1, 2).continuous);
}

/// floor(x) < 3 is as continuous as it is decided, whatever floor does.
TEST(Interpret, KnowsContinuousConditionsOfJumps) {
    const auto low_floor = [](ExprBuilder& builder, NodeId x) {
        return builder.apply(Op::Less, builder.apply(Op::Floor, x), builder.constant(3));
    };
    EXPECT_TRUE(range_of(low_floor, 0.5F, 2.5F).continuous);
    EXPECT_EQ(range_of(low_floor, 0.5F, 2.5F).lo, 1);
    EXPECT_FALSE(range_of(low_floor, 2.5F, 3.5F).continuous);
    EXPECT_TRUE(range_of(low_floor, 3, 4.5F).continuous);
    EXPECT_EQ(range_of(low_floor, 3, 4.5F).hi, 0);
    const auto low_root = [](ExprBuilder& builder, NodeId x) {
        return builder.apply(Op::Less, builder.apply(Op::Sqrt, x), builder.constant(3));
    };
    EXPECT_FALSE(range_of(low_root, -1, 2).continuous);
    EXPECT_EQ(range_of(low_root, -2, -1).hi, nowhere);
}

TEST(Interpret, EnclosesWhereItJumps) {
    EXPECT_FALSE(range_over("floor(x)", 2.5F, 3.5F).continuous);
    EXPECT_TRUE(range_over("floor(x)", 2.25F, 2.5F).continuous);
    EXPECT_FALSE(range_over("tan(x)", 1, 2).continuous);
    EXPECT_TRUE(range_over("tan(x)", 2, 3).continuous);
    EXPECT_FALSE(range_over("mod(x, 2)", 1, 3).continuous);
    EXPECT_EQ(range_over("mod(x, 2)", 2.5F, 3).lo, 0.5F);
    EXPECT_TRUE(range_over("mod(x, 2)", 2.5F, 3).continuous);
    EXPECT_EQ(range_over("1/0 + x", 1, 2).hi, nowhere);
}

// 0 * infinity must not make a product of numbers that are never negative the whole line: what is
// built on it takes it for never negative.
TEST(Interpret, EnclosesMultiplesOfWhatOverflows) {
    for (const char* const text : {"(0*x^58)^2", "(0/3*x^58)^2", "(1e-300*x^58)^2", "sqrt(0*x^58)",
                                   "0*x^58*(0*x^58)", "(1e300*0*x^58)^2"}) {
        const auto range = range_over(text, 10'000, 20'000);
        EXPECT_LE(range.lo, 0.0F) << text;
        EXPECT_GE(range.hi, 0.0F) << text;
    }
}

/// Range and value of one item, by the algebras over single floats.
Bits of_one_lane(const Expr& expr, const std::array<Interval<float>, 3>& box,
                 const std::array<float, 3>& point, const Uniforms& uniforms) {
    const std::vector<Facts> facts = facts_of(expr);
    const UpwardRounding upward;
    IntervalAlgebra<float> intervals;
    const auto box_leaf = [&](const Node& node, const Facts& fact) -> Enclosure<float> {
        if (fact.constant) {
            return {{float_above(fact.constant->neg_lo), float_above(fact.constant->hi)}};
        }
        if (node.number < variable_w) return {box.at(static_cast<std::size_t>(node.number))};
        return {{uniforms.neg_lo_hi[0], uniforms.neg_lo_hi[1]}};
    };
    const Enclosure<float> f = evaluate(expr, facts, intervals, box_leaf, [] {});
    DualAlgebra<float> duals;
    const auto point_leaf = [&](const Node& node, const Facts& fact) -> Dual<float> {
        if (fact.constant) return {fact.middle_float, {}};
        if (node.number == variable_w) return {uniforms.middle[0], {}};
        const auto v = static_cast<std::size_t>(node.number);
        Dual<float> variable{point.at(v), {}};
        variable.slope.set(v, 1.0F);
        return variable;
    };
    const Dual<float> value = evaluate(expr, facts, duals, point_leaf, [] {});
    const Interval<float> range = answer(f);
    const bool proved = f.everywhere.value_or(true) && f.continuous.value_or(true);
    return one_item(
        range, proved, value.value,
        {value.slope[0].value_or(0), value.slope[1].value_or(0), value.slope[2].value_or(0)});
}

/// The interpreter works on blocks of lanes: each lane is what a single float would be.
TEST(Interpret, HasTheBitsOfOneLane) {
    RandomNumbers random(53);
    for (int i = 0; i < 1500 && !testing::Test::HasFailure(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        const Expr expr = row < operators().size() ? operator_on_variables(operators()[row], 5)
                                                   : random_expression(random, 1 + i % 5);
        const KernelBatch batch(random, items);
        const Bits found = batch.run(interpret(expr));
        for (std::size_t k = 0; k < items; ++k) {
            const Bits expected = of_one_lane(expr, batch.box(k), batch.point(k), batch.uniforms);
            ASSERT_EQ(expected, item(found, k)) << expr.canonical() << ", item " << k;
        }
    }
}

/// A graph whose values need far more than the slots that are alive at once.
TEST(Interpret, UsesItsSlotsAgain) {
    ExprBuilder builder;
    NodeId sum = builder.variable(0);
    for (int i = 1; i < 2000; ++i) {
        const NodeId term = builder.apply(Op::Multiply, sum, builder.variable(i % 3));
        sum = builder.apply(Op::Max, builder.apply(Op::Sin, term), sum);
    }
    const Expr expr = builder.finish(sum);
    EXPECT_LT(Tape(std::make_shared<const TapeGraph>(expr, facts_of(expr), Parts{})).slots(), 10);
    RandomNumbers random(52);
    for (int i = 0; i < 20; ++i) {
        const float x = static_cast<float>(random.uniform(-2, 2));
        const Answer found = range_over(expr, x, x);
        const auto at = static_cast<double>(x);
        const auto value = static_cast<float>(value_at(expr, {at, at, at, 0}).value);
        EXPECT_GE(value, found.lo);
        EXPECT_LE(value, found.hi);
    }
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

/// Double is for boxes far below the resolution of float.
TEST(Interpret, TellsTinyBoxesApartInDouble) {
    const Kernel kernel = interpret(*parse("x^2 + y^2 + z^2 + sin(w)*0 - 0.75"));
    std::array<double, items> neg_lo{};
    std::array<double, items> hi{};
    std::array<double, items> f_neg_lo{};
    std::array<double, items> f_hi{};
    std::array<std::uint64_t, items> continuous{};
    constexpr double size = 1e-12;
    for (std::size_t i = 0; i < items; ++i) {
        const double lo = 0.5 + size * (static_cast<double>(i) - 7.5);
        neg_lo[i] = -lo;
        hi[i] = lo + size;
    }
    Uniforms uniforms;
    uniforms.set(0, 0.1);
    const UpwardRounding upward;
    kernel.range(RangeBatchOf<double>{items,
                                      {neg_lo.data(), neg_lo.data(), neg_lo.data()},
                                      {hi.data(), hi.data(), hi.data()},
                                      uniforms.boxes<double>(),
                                      f_neg_lo.data(),
                                      f_hi.data(),
                                      continuous.data()});
    for (std::size_t i = 0; i < items; ++i) {
        const bool holds_zero = f_neg_lo.at(i) >= 0 && f_hi.at(i) >= 0;
        EXPECT_EQ(holds_zero, i == 7) << i;
        EXPECT_LT(f_neg_lo.at(i) + f_hi.at(i), 3.01 * size);
        EXPECT_EQ(continuous.at(i), ~std::uint64_t{0});
    }
}

TEST(Interpret, HasTheGradientInDouble) {
    const Kernel kernel = interpret(*parse("x^3 + log10(y)*log2(z) - w"));
    std::array<std::array<double, items>, 3> x{};
    x[0].fill(0.1);
    x[1].fill(3);
    x[2].fill(5);
    std::array<double, items> f{};
    std::array<std::array<double, items>, 3> gradient{};
    Uniforms uniforms;
    uniforms.set(0, 0.2, 0.4);
    {
        const UpwardRounding upward;
        kernel.value(
            ValueBatchOf<double>{items,
                                 {x[0].data(), x[1].data(), x[2].data()},
                                 uniforms.points<double>(),
                                 f.data(),
                                 {gradient[0].data(), gradient[1].data(), gradient[2].data()}});
    }
    constexpr double few_ulp = 1e-15;
    const double ln2 = std::log(2.0);
    const double ln10 = std::log(10.0);
    EXPECT_NEAR(f[items - 1], 0.001 + std::log10(3.0) * std::log2(5.0) - 0.3, few_ulp);
    EXPECT_NEAR(gradient[0][items - 1], 0.03, few_ulp);
    EXPECT_NEAR(gradient[1][items - 1], std::log2(5.0) / (3 * ln10), few_ulp);
    EXPECT_NEAR(gradient[2][items - 1], std::log10(3.0) / (5 * ln2), few_ulp);
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
    EXPECT_EQ(uniforms.neg_lo_hi_double, (std::vector<double>{0, 0, -0.1, 0.3}));
    EXPECT_EQ(uniforms.middle_double, (std::vector<double>{0, 0.2}));
    uniforms.set(0, 0.5);
    EXPECT_EQ(uniforms.neg_lo_hi[0], -0.5F);
    EXPECT_EQ(uniforms.neg_lo_hi[1], 0.5F);
}

}  // namespace
}  // namespace zeroset::test::interpret_test
