#include "engine/expr/facts.hpp"

#include "engine/expr/parse.hpp"

#include <gtest/gtest.h>

#include <cfenv>

namespace zeroset {
namespace {

Facts root_facts(const char* text) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr.has_value()) << text;
    return facts_of(*expr).back();
}

TEST(Facts, KnowsWhatIsNeverNegative) {
    for (const char* const text : {"x^2", "x^16", "abs(x)", "sqrt(x)", "exp(x)", "acos(x)",
                                   "x^2 + y^4", "x^2*abs(y)", "abs(x)^3", "2", "0", "min(x^2, 3)",
                                   "max(x^2, y)", "max(x, y^2)", "3*x^2 + 1", "2 - 1"}) {
        EXPECT_TRUE(root_facts(text).nonnegative) << text;
    }
    for (const char* const text :
         {"x", "x^3", "-x^2", "x^2 - 1", "x^2*y", "-2", "min(x^2, y)", "max(x, y)", "sin(x)",
          "log(x)", "atan2(y, x)", "x^2/y", "1 - 2"}) {
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

// The C library's functions have no proved bound.
TEST(Facts, LeavesFunctionsToRunTime) {
    for (const char* const text :
         {"sin(1)", "cos(1)", "acos(0.5)", "exp(1)", "log(2)", "atan2(1, 2)"}) {
        EXPECT_FALSE(root_facts(text).constant.has_value()) << text;
    }
}

TEST(Facts, LeavesTheRoundingMode) {
    root_facts("0.1*0.2 - 0.3");
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

}  // namespace
}  // namespace zeroset
