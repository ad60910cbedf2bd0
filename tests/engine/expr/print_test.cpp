#include "engine/expr/expr.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// Tests of the canonical form of a formula, which parses to the same graph.

namespace zeroset::print_test {
namespace {

std::string canonical(const std::string& text) {
    const auto expr = parse(text);
    return expr ? expr->canonical() : "refused: " + expr.error().reason;
}

void expect_round_trip(const Expr& expr) {
    const std::string text = expr.canonical();
    const auto again = parse(text);
    ASSERT_TRUE(again.has_value()) << text << ": " << again.error().reason;
    EXPECT_EQ(again->key(), expr.key()) << text << " became " << again->canonical();
}

TEST(Canonical, WritesEveryOperator) {
    EXPECT_EQ(canonical("x+y"), "x + y");
    EXPECT_EQ(canonical("x=y"), "x - y");
    EXPECT_EQ(canonical("x * y"), "x*y");
    EXPECT_EQ(canonical("x / y"), "x/y");
    EXPECT_EQ(canonical("- x"), "-x");
    EXPECT_EQ(canonical("x*x"), "x^2");
    EXPECT_EQ(canonical("x ^ 3"), "x^3");
    EXPECT_EQ(canonical("x^-3"), "1/x^3");
    EXPECT_EQ(canonical("x^0.5"), "sqrt(x)");
    EXPECT_EQ(canonical("atan2(y,x)"), "atan2(y, x)");
    EXPECT_EQ(canonical("min(x,y,z)"), "min(min(x, y), z)");
}

TEST(Canonical, KeepsOnlyNeededParentheses) {
    EXPECT_EQ(canonical("((x)+(y))*(z)"), "(x + y)*z");
    EXPECT_EQ(canonical("(x*y)*z"), "x*y*z");
    EXPECT_EQ(canonical("x*(y*z)"), "x*(y*z)");
    EXPECT_EQ(canonical("x-(y-z)"), "x - (y - z)");
    EXPECT_EQ(canonical("(x-y)-z"), "x - y - z");
    EXPECT_EQ(canonical("x+(y*z)"), "x + y*z");
    EXPECT_EQ(canonical("(-x)^2"), "x^2");
    EXPECT_EQ(canonical("-(x^2)"), "-x^2");
    EXPECT_EQ(canonical("(x^2)^3"), "x^6");
    EXPECT_EQ(canonical("(-2)^2*x"), "(-2)^2*x");
    EXPECT_EQ(canonical("if(not (x<y and y<z) or x<=z, x, y)"),
              "if(not (x < y and y < z) or x <= z, x, y)");
    EXPECT_EQ(canonical("x*(-y)"), "x*-y");
    EXPECT_EQ(canonical("-(x*y)"), "-(x*y)");
}

TEST(Canonical, ParsesToTheSameGraph) {
    for (const char* const text : {"x",
                                   "0",
                                   "0.1",
                                   "-0.1",
                                   "1e-300",
                                   "1e300",
                                   "1e-320",
                                   "0.1 + 0.2",
                                   "x - -2",
                                   "x - (-0.1)",
                                   "2^3^2",
                                   "(-x)^2 - -x^2",
                                   "x^2^3",
                                   "(x^2)^3",
                                   "x/(y/z)",
                                   "x/y/z",
                                   "x/(y*z)",
                                   "-(-x)",
                                   "-(x + y)",
                                   "sin(3*atan2(y, x))",
                                   "atan2(y, x) + sin(atan2(y, x))",
                                   "cos(-(2*atan2(y, x))*3)",
                                   "x^0.3",
                                   "x^y",
                                   "2^x",
                                   "x^(1/2)",
                                   "min(x, max(y, -z), w)",
                                   "123456789012345678901234567890*x",
                                   "3.141592653589793238462643383279502884*x"}) {
        const auto expr = parse(text);
        ASSERT_TRUE(expr.has_value()) << text << ": " << expr.error().reason;
        expect_round_trip(*expr);
    }
}

TEST(Canonical, ParsesToTheSameGraphWhateverTheGraph) {
    test::RandomNumbers random(21);
    for (int i = 0; i < 8000 && !testing::Test::HasFailure(); ++i) {
        const Expr expr = test::random_expression(random, i % 7);
        const bool drawn = std::ranges::any_of(expr.nodes(), [](const Node& node) {
            if (arity(node.op) == 0) return false;
            const Notation notation = op_info(node.op).notation;
            return notation == Notation::Wave || notation == Notation::Lookup ||
                   (notation == Notation::Internal && node.op != Op::Angle);
        });
        if (!drawn) expect_round_trip(expr);
    }
}

TEST(EquationText, HasOneSignBeforeANumber) {
    const auto read = [](const char* text) { return equation_text(parse(text).value()); };
    EXPECT_EQ(read("x^2 + y^2 = -1"), "x^2 + y^2 + 1 = 0");
    EXPECT_EQ(read("x + (-0.1)"), "x - 0.1 = 0");
    EXPECT_EQ(read("x - -pi"), "x + pi = 0");
    EXPECT_EQ(read("x - -y"), "x + y = 0");
}

TEST(Canonical, WritesAnOrientedNumeratorAsItsQuotient) {
    ExprBuilder builder;
    const NodeId sum = builder.apply(Op::Add, builder.variable(0), builder.variable(1));
    const NodeId inner = builder.apply(Op::Oriented, sum, builder.variable(2));
    EXPECT_EQ(builder.finish(inner).canonical(), "(x + y)/z");
    EXPECT_EQ(builder.finish(builder.apply(Op::Oriented, inner, sum)).canonical(),
              "(x + y)/z/(x + y)");
}

TEST(Canonical, WritesLengthsAndWavesAsTheyAreTyped) {
    ExprBuilder builder;
    const NodeId sum = builder.apply(Op::Add, builder.variable(0), builder.variable(1));
    const NodeId z = builder.variable(2);
    EXPECT_EQ(builder.finish(builder.apply(Op::Length, sum, z)).canonical(),
              "sqrt(z^2 + (x + y)^2)");
    EXPECT_EQ(builder.finish(builder.apply(Op::AngleSin, sum, z, 0, 3)).canonical(),
              "sin(3*atan2(x + y, z))");
    EXPECT_EQ(builder.finish(builder.apply(Op::AngleCos, z, sum, 0, 1)).canonical(),
              "cos(atan2(z, x + y))");
}

TEST(Canonical, OfNothingIsEmpty) { EXPECT_EQ(Expr().canonical(), ""); }

TEST(Key, TellsGraphsApart) {
    EXPECT_EQ(parse("x*x + y")->key(), parse("x^2 + y")->key());
    EXPECT_NE(parse("x + y")->key(), parse("y + x")->key());
    EXPECT_NE(parse("x^2")->key(), parse("x^3")->key());
    EXPECT_NE(parse("x*0.1")->key(), parse("x*0.10000000000000001")->key());
    EXPECT_NE(parse("atan2(y, x)")->key(), parse("atan2(x, y)")->key());
}

TEST(Expr, SharesEqualParts) {
    EXPECT_EQ(parse("(x + y)*sin(x + y)")->nodes().size(), 5);
    EXPECT_EQ(parse("x - x")->nodes().size(), 2);
    EXPECT_EQ(parse("x + y*0 - y*0")->uses_variable(1), true);
    EXPECT_EQ(parse("x + z")->uses_variable(1), false);
}

}  // namespace
}  // namespace zeroset::print_test
