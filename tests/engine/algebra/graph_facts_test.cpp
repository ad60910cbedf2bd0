#include "engine/algebra/graph_facts.hpp"

#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <utility>

namespace zeroset::graph_facts_test {
namespace {

Facts root_facts(const char* text) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr.has_value()) << text;
    return facts_of(*expr).back();
}

TEST(Facts, KnowsWhatIsNeverNegative) {
    for (const char* const text : {"x^2",
                                   "x^16",
                                   "abs(x)",
                                   "sqrt(x)",
                                   "exp(x)",
                                   "acos(x)",
                                   "x^2 + y^4",
                                   "x^2*abs(y)",
                                   "abs(x)^3",
                                   "2",
                                   "0",
                                   "min(x^2, 3)",
                                   "max(x^2, y)",
                                   "max(x, y^2)",
                                   "3*x^2 + 1",
                                   "2 - 1",
                                   "cosh(x)",
                                   "acosh(x)",
                                   "sinh(x^2)",
                                   "floor(abs(x))",
                                   "mod(x, y^2)",
                                   "if(x > 0, y^2, 1)",
                                   "if(y > 0, 2, 3)"}) {
        EXPECT_TRUE(root_facts(text).nonnegative) << text;
    }
    for (const char* const text :
         {"x", "x^3", "-x^2", "x^2 - 1", "x^2*y", "-2", "min(x^2, y)", "max(x, y)", "sin(x)",
          "ln(x)", "tan(x)", "floor(x)", "mod(x, y)", "if(x > 0, y, 1)", "sinh(x)", "atan2(y, x)",
          "x^2/y", "1 - 2"}) {
        EXPECT_FALSE(root_facts(text).nonnegative) << text;
    }
}

TEST(Facts, KnowsWhatDependsOnNoPoint) {
    EXPECT_TRUE(root_facts("w").uniform);
    EXPECT_TRUE(root_facts("sin(w)*2 + w^3").uniform);
    EXPECT_TRUE(root_facts("2").uniform);
    EXPECT_FALSE(root_facts("w*x").uniform);
    EXPECT_FALSE(root_facts("y").uniform);
}

TEST(Facts, FoldsConstants) {
    EXPECT_TRUE(root_facts("2 + 3*4").exact());
    EXPECT_EQ(root_facts("2 + 3*4").constant->hi, 14.0);
    EXPECT_EQ(root_facts("sqrt(16)").constant->hi, 4.0);
    EXPECT_EQ(root_facts("2^10").constant->hi, 1024.0);
    const Facts tenth = root_facts("0.1 + 0.2");
    ASSERT_TRUE(tenth.constant.has_value());
    EXPECT_FALSE(tenth.exact());
    EXPECT_LT(-tenth.constant->neg_lo, 0.3);
    EXPECT_GT(tenth.constant->hi, 0.3);
    EXPECT_FALSE(root_facts("w + 1").constant.has_value());
}

TEST(Facts, FoldsNothingUndefined) {
    for (const char* const text :
         {"1/0", "1/(1 - 1)", "sqrt(-1)", "sqrt(1 - 2)", "0/0", "1e300*1e300"}) {
        EXPECT_FALSE(root_facts(text).constant.has_value()) << text;
    }
}

TEST(Facts, KnowsWhatIsUndefined) {
    for (const char* const text :
         {"1/0", "1/(1 - 1)", "sqrt(-1)", "x + sqrt(1 - 2)", "acos(2)", "ln(0)", "mod(3, 0)",
          "if(1 > 0, sqrt(-1), 2)", "if(sqrt(-1) > 0, 1, 2)", "if(x > 0, sqrt(-1), 1/0)",
          "acosh(0.5)"}) {
        EXPECT_TRUE(root_facts(text).undefined) << text;
    }
    for (const char* const text : {"1/x", "sqrt(x)", "1/(0.1 - 0.1)", "if(x > 0, sqrt(-1), 2)",
                                   "if(1 > 0, 2, sqrt(-1))", "if(0 > 0, 1/0, x)", "1e300*1e300"}) {
        EXPECT_FALSE(root_facts(text).undefined) << text;
    }
}

/// A fold of a function is the last ulps around the true value.
TEST(Facts, FoldsFunctions) {
    const std::pair<const char*, double> cases[] = {{"sin(1)", std::sin(1)},
                                                    {"cos(1)", std::cos(1)},
                                                    {"acos(0.5)", std::acos(0.5)},
                                                    {"exp(1)", std::exp(1)},
                                                    {"ln(2)", std::log(2)},
                                                    {"atan2(1, 2)", std::atan2(1, 2)},
                                                    {"tan(1)", std::tan(1)},
                                                    {"cot(2)", 1 / std::tan(2)},
                                                    {"sinh(-300)", std::sinh(-300)},
                                                    {"asinh(1e300)", std::asinh(1e300)},
                                                    {"log10(1000)", 3},
                                                    {"round(2.5)", 3},
                                                    {"mod(7, 2.5)", 2},
                                                    {"if(2 > 0, 3, 4)", 3}};
    for (const auto& [text, value] : cases) {
        const Facts facts = root_facts(text);
        ASSERT_TRUE(facts.constant.has_value()) << text;
        EXPECT_LE(-facts.constant->neg_lo, value) << text;
        EXPECT_GE(facts.constant->hi, value) << text;
        EXPECT_LE(facts.constant->hi + facts.constant->neg_lo, 1e-14 * std::abs(value)) << text;
    }
}

TEST(Facts, LeavesTheRoundingMode) {
    root_facts("0.1*0.2 - 0.3");
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

}  // namespace
}  // namespace zeroset::graph_facts_test
