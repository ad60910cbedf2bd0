#include "engine/algebra/graph_facts.hpp"
#include "engine/algebra/switches.hpp"
#include "engine/language/parse.hpp"
#include "engine/rewrite/passes.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

namespace zeroset::plain_conditions_test {
namespace {

std::string written(const std::string& text) {
    return with_plain_conditions(*parse(text)).canonical();
}

TEST(WithPlainConditions, CompareWithOneConstant) {
    EXPECT_EQ(written("if(abs(x - 2/3) < 1/9, y, z)"), "if(5/9 < x and x < 7/9, y, z)");
    EXPECT_EQ(written("if(abs(2 - 4x) >= 2, y, z)"), "if(1 <= x or x <= 0, y, z)");
    EXPECT_EQ(written("if(1 - (x^3 + 3)/2 < 0, y, z)"), "if(-1 < x^3, y, z)");
    EXPECT_EQ(written("if(-x/2 < 1, y, z)"), "if(-2 < x, y, z)");
}

TEST(WithPlainConditions, SumsOfChoicesAreConditions) {
    EXPECT_EQ(written("if(if(x < 0, 1, 0) + if(y < 0, 1, 0) <= 0, x, z)"),
              "if(0 <= x and 0 <= y, x, z)");
    EXPECT_EQ(written("if(if(x < 0, 1, 0)*if(y < 0, 1, 0) > 0.5, x, z)"),
              "if(x < 0 and y < 0, x, z)");
    EXPECT_EQ(written("if(abs(if(x < 0, 1, 0)) > 0.5, x, z)"), "if(x < 0, x, z)");
    EXPECT_EQ(written("if(if(x < 0, 1, 0) >= 0 and y < 0, x, z)"), "if(y < 0, x, z)");
    EXPECT_EQ(written("if(if(x < 0, 3, 5) > 5, y, z)"), "z");
    EXPECT_EQ(written("if(x < 0, 1, 0)*if(y < 0, 1, 0)*z"), "if(x < 0 and y < 0, 1, 0)*z");
    EXPECT_EQ(written("where(x, if(y < 0, 1, 2) > 0)"), "x");
}

TEST(WithPlainConditions, LeavesOthersAlone) {
    for (const char* text : {"if(x < y, 1, 0)", "if(abs(x) < y, x, z)", "if(sqrt(x) < 2, x, z)",
                             "if(x^2 <= 0, y, z)", "if(abs(x) <= 0, y, z)", "abs(x) + 1/2"})
        EXPECT_EQ(written(text), parse(text)->canonical()) << text;
}

/// The parts that could be left out are undefined somewhere.
TEST(WithPlainConditions, KeepTheDomain) {
    EXPECT_EQ(written("if(sqrt(x) > -1, y, z)"), parse("if(sqrt(x) > -1, y, z)")->canonical());
    EXPECT_EQ(written("if(sqrt(x) < 1 and 1 < 0, y, z)"), "if(sqrt(x) < 1 and 0, y, z)");
}

/// A condition of random comparisons of random formulas with constants.
std::string random_condition(test::RandomNumbers& random, int depth) {
    static constexpr std::array values{"x",
                                       "2y - 1/3",
                                       "abs(x - 0.3)",
                                       "abs(y/3) - 1/7",
                                       "if(z < 1/4, 1, 0)",
                                       "if(x < 0, 2, -1)",
                                       "-3*abs(z + 1)",
                                       "if(y < 0.2, 1, 0) + if(abs(x) < 1/3, 1, 0)",
                                       "if(x < y, 1, 0)*if(z <= 0.5, 1, 0)",
                                       "1 - 2*(x + 0.5)/4"};
    static constexpr std::array limits{"0", "1", "0.5", "-1/3", "2", "7/9", "-2.5"};
    static constexpr std::array relations{"<", "<=", ">", ">="};
    const auto pick = [&](const auto& list) {
        return std::string(list[random.below(list.size())]);
    };
    if (depth == 0) return pick(values) + " " + pick(relations) + " " + pick(limits);
    const std::string a = random_condition(random, depth - 1);
    const std::string b = random_condition(random, depth - 1);
    if (random.below(3) == 0) return "not (" + a + ")";
    return "(" + a + (random.below(2) == 0 ? ") and (" : ") or (") + b + ")";
}

TEST(WithPlainConditions, AreTheSameFunctionWhateverTheFormula) {
    test::RandomNumbers random(11);
    for (int i = 0; i < 2000; ++i) {
        const std::string text = "if(" + random_condition(random, i % 4) + ", x + 1, y*z)*if(" +
                                 random_condition(random, i % 3) + ", 1, 0)";
        const Expr typed = *parse(text);
        const Expr plain = with_plain_conditions(typed);
        for (int point = 0; point < 20; ++point) {
            std::array<double, 4> at{};
            for (double& coordinate : at)
                coordinate =
                    point < 10 ? random.uniform(-2, 2) : 0.25 * std::round(random.uniform(-8, 8));
            const auto expected = test::reference(typed, at);
            const auto found = test::reference(plain, at);
            ASSERT_EQ(expected.value.nearest(), found.value.nearest())
                << text << "\n"
                << plain.canonical() << "\n"
                << at[0] << " " << at[1] << " " << at[2];
        }
    }
}

/// The outermost condition of those made of others is the switch.
TEST(Switches, AreOutermostConditions) {
    const auto count = [](const char* text) {
        const Expr expr = *parse(text);
        return count_switches(switches_of(expr, facts_of(expr)));
    };
    EXPECT_EQ(count("if(x < 0 and (y < 0 or not (z < x and y < z)), x, z)"), 1U);
    EXPECT_EQ(count("if(x < 0, x, z) + if(x < 0 and y < 0, 1, 0)"), 2U);
    EXPECT_EQ(count("floor(x) + if(w < 0 or w > 2, 1, 0)"), 1U);
}

}  // namespace
}  // namespace zeroset::plain_conditions_test
