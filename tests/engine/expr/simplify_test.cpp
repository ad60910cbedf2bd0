#include "engine/expr/simplify.hpp"

#include "engine/expr/exact.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace zeroset::simplify_test {
namespace {

Op root_op(const char* text) {
    const auto expr = parse(text);
    return expr->node(expr->root()).op;
}

bool has_op(const char* text, Op op) {
    const auto expr = parse(text);
    for (const Node& node : expr->nodes()) {
        if (node.op == op) return true;
    }
    return false;
}

TEST(Simplify, MakesAQuotientOfEqualsOneButAtZero) {
    EXPECT_FALSE(has_op("(x - y)/(x - y)", Op::Divide));
    const Expr quotient = *parse("x/x");
    EXPECT_EQ(value_at(quotient, {-0.25, 0, 0, 0}, {}).value, 1.0);
    EXPECT_EQ(value_at(quotient, {3, 0, 0, 0}, {}).value, 1.0);
    EXPECT_TRUE(std::isnan(value_at(quotient, {0, 0, 0, 0}, {}).value));
}

TEST(Simplify, DropsWhatChangesNothing) {
    EXPECT_EQ(parse("x + 0")->key(), parse("x")->key());
    EXPECT_EQ(parse("x - 0")->key(), parse("x")->key());
    EXPECT_EQ(parse("--x")->key(), parse("x")->key());
    EXPECT_EQ(parse("x^1")->key(), parse("x")->key());
    EXPECT_EQ(parse("x^0")->key(), parse("1")->key());
    EXPECT_EQ(parse("x^0.5")->key(), parse("sqrt(x)")->key());
}

TEST(Simplify, MakesSquaresOfProducts) {
    EXPECT_EQ(parse("x*x")->key(), parse("x^2")->key());
    EXPECT_EQ(parse("(x + y)*(x + y)")->key(), parse("(x + y)^2")->key());
    EXPECT_EQ(root_op("x*y"), Op::Multiply);
}

TEST(Simplify, MakesPowersByTheExponent) {
    EXPECT_EQ(root_op("x^3"), Op::IntPower);
    EXPECT_EQ(root_op("x^-3"), Op::Divide);
    EXPECT_EQ(root_op("x^(5 - 2)"), Op::IntPower);
    EXPECT_EQ(root_op("x^0.3"), Op::IntPower);
    EXPECT_EQ(root_op("x^0.317"), Op::Exp);
    EXPECT_EQ(root_op("x^(-1/3)"), Op::Divide);
    EXPECT_EQ(root_op("x^(1/5)"), Op::OddRoot);
    EXPECT_EQ(root_op("e^x"), Op::Exp);
    EXPECT_EQ(root_op("x^y"), Op::Exp);
}

TEST(Simplify, SquaresRootsOfWhatIsNeverNegative) {
    EXPECT_EQ(parse("r^2")->key(), parse("x^2 + y^2 + z^2")->key());
    EXPECT_EQ(parse("rho*rho")->key(), parse("x^2 + y^2")->key());
    EXPECT_EQ(parse("sqrt(x^2 + |y| + 2)^4")->key(), parse("(x^2 + |y| + 2)^2")->key());
    EXPECT_EQ(root_op("sqrt(x)^2"), Op::IntPower) << "undefined below 0";
    EXPECT_EQ(root_op("sqrt(x^2 + y)^2"), Op::IntPower);
    EXPECT_EQ(root_op("r^3"), Op::IntPower);
}

TEST(Simplify, NegatesConstants) {
    const auto expr = parse("-0.1");
    ASSERT_EQ(expr->nodes().size(), 1);
    EXPECT_LT(expr->node(0).lo, expr->node(0).hi);
    EXPECT_LT(expr->node(0).hi, 0);
}

TEST(Simplify, RemovesTheCutUnderWaves) {
    EXPECT_TRUE(has_op("sin(atan2(y, x))", Op::Angle));
    EXPECT_TRUE(has_op("cos(3*atan2(y, x))", Op::Angle));
    EXPECT_TRUE(has_op("cos(-(atan2(y, x)*4))", Op::Angle));
    EXPECT_TRUE(has_op("sin((2 + 1)*atan2(y, x))", Op::Angle));
}

TEST(Simplify, KeepsTheCutElsewhere) {
    EXPECT_FALSE(has_op("atan2(y, x)", Op::Angle));
    EXPECT_FALSE(has_op("sin(0.5*atan2(y, x))", Op::Angle));
    EXPECT_FALSE(has_op("sin(atan2(y, x)/2)", Op::Angle));
    EXPECT_FALSE(has_op("sin(z*atan2(y, x))", Op::Angle));
    EXPECT_FALSE(has_op("exp(atan2(y, x))", Op::Angle));
    EXPECT_TRUE(has_op("sin(atan2(y, x)) + atan2(y, x)", Op::Atan2));
}

TEST(ExactValue, FoldsFractions) {
    ExprBuilder builder;
    const NodeId two = builder.constant(2);
    const NodeId three = builder.constant(3);
    const NodeId half = builder.constant(0.5);
    const NodeId x = builder.variable(0);
    EXPECT_EQ(exact_value(builder, two), 2.0);
    EXPECT_EQ(exact_value(builder, half), 0.5);
    EXPECT_EQ(exact_value(builder, make_add(builder, two, three)), 5.0);
    EXPECT_EQ(exact_value(builder, make_subtract(builder, two, three)), -1.0);
    EXPECT_EQ(exact_value(builder, make_multiply(builder, two, three)), 6.0);
    EXPECT_EQ(exact_value(builder, make_add(builder, half, two)), 2.5);
    EXPECT_EQ(exact_value(builder, make_add(builder, x, two)), std::nullopt);
    EXPECT_EQ(exact_value(builder, builder.constant(0.1, 0.2)), std::nullopt);
    EXPECT_EQ(exact_value(builder, make_divide(builder, two, three)), std::nullopt);
    const NodeId large = builder.constant(0x1p53);
    EXPECT_EQ(exact_value(builder, make_add(builder, large, two)), std::nullopt);
}

}  // namespace
}  // namespace zeroset::simplify_test
