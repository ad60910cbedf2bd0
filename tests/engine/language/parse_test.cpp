#include "engine/language/parse.hpp"

#include "engine/interpret/interpret.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <thread>

namespace zeroset::parse_test {
namespace {

/// Returns f at (x, y, z, w) = (2, 3, 5, 7); NaN, and a test failure, if the text is wrong.
double value_of(std::string_view text) {
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << text << ": " << expr.error().reason << " at " << expr.error().offset;
        return std::nan("");
    }
    return value_at(*expr, {2, 3, 5, 7}).value;
}

TEST(Parse, TakesTheVariables) {
    EXPECT_EQ(value_of("x"), 2);
    EXPECT_EQ(value_of("y"), 3);
    EXPECT_EQ(value_of("z"), 5);
    EXPECT_EQ(value_of("w"), 7);
    EXPECT_EQ(value_of("  x\t+\r\n y "), 5);
}

TEST(Parse, TakesNumbers) {
    EXPECT_EQ(value_of("12"), 12);
    EXPECT_EQ(value_of("1."), 1);
    EXPECT_EQ(value_of(".5"), 0.5);
    EXPECT_EQ(value_of("1.5e2"), 150);
    EXPECT_EQ(value_of("1.5E+2"), 150);
    EXPECT_EQ(value_of("25e-2"), 0.25);
    EXPECT_EQ(value_of("0"), 0);
    EXPECT_EQ(value_of("1e300"), 1e300);
}

TEST(Parse, BindsByPrecedence) {
    EXPECT_EQ(value_of("x + y*z"), 17);
    EXPECT_EQ(value_of("x*y + z"), 11);
    EXPECT_EQ(value_of("(x + y)*z"), 25);
    EXPECT_EQ(value_of("x*y^2"), 18);
    EXPECT_EQ(value_of("(x*y)^2"), 36);
    EXPECT_EQ(value_of("x + y^2*z"), 47);
    EXPECT_EQ(value_of("x = y*z"), -13);
}

TEST(Parse, AssociatesToTheLeftExceptPowers) {
    EXPECT_EQ(value_of("x - y - z"), -6);
    EXPECT_EQ(value_of("x - (y - z)"), 4);
    EXPECT_EQ(value_of("60/x/y"), 10);
    EXPECT_EQ(value_of("60/x*y"), 90);
    EXPECT_NEAR(value_of("2^3^2"), 512, 1e-9);
    EXPECT_EQ(value_of("(2^3)^2"), 64);
}

TEST(Parse, PutsPowersBeforeSigns) {
    EXPECT_EQ(value_of("-x^2"), -4);
    EXPECT_EQ(value_of("(-x)^2"), 4);
    EXPECT_EQ(value_of("2^-x"), 0.25);
    EXPECT_EQ(value_of("x^-2"), 0.25);
    EXPECT_EQ(value_of("--x"), 2);
    EXPECT_EQ(value_of("-+-+x"), 2);
    EXPECT_EQ(value_of("x - -y"), 5);
    EXPECT_EQ(value_of("x*-y"), -6);
    EXPECT_EQ(value_of("-x*y"), -6);
    EXPECT_EQ(value_of("2 - -3^2"), 11);
}

TEST(Parse, TakesRealPowers) {
    EXPECT_EQ(value_of("4^0.5"), 2);
    EXPECT_EQ(value_of("x^0"), 1);
    EXPECT_EQ(value_of("x^1"), 2);
    EXPECT_EQ(value_of("x^(1 + 2)"), 8);
    EXPECT_NEAR(value_of("x^y"), 8, 1e-14);
    EXPECT_NEAR(value_of("x^(1/3)"), std::cbrt(2.0), 1e-15);
}

// Real powers need a positive base, integer powers do not; so integer exponents must be recognised.
TEST(Parse, FindsIntegerExponentsHoweverTheyAreWritten) {
    EXPECT_EQ(value_of("(-x)^(1 + 2)"), -8);
    EXPECT_EQ(value_of("(-x)^(2*2)"), 16);
    EXPECT_EQ(value_of("(-x)^-(1)"), -0.5);
    EXPECT_EQ(value_of("(-x)^+2"), 4);
    EXPECT_EQ(value_of("(-x)^2^2"), 16);
    EXPECT_EQ(value_of("(-x)^(6/2)"), -8);
}

TEST(Parse, TakesEveryFunctionOfTheTable) {
    static constexpr std::array arguments{"(x)", "(x, y)", "(x, y, z)"};
    for (const OpInfo& info : operators()) {
        if (info.notation != Notation::Call) continue;
        const std::string name(info.spelling);
        const std::string typed = info.op == Op::If ? "(x < y, y, z)"
                                  : info.op == Op::Where
                                      ? "(x, y < z)"
                                      : arguments.at(static_cast<std::size_t>(info.arity - 1));
        const auto expr = parse(name + typed);
        ASSERT_TRUE(expr.has_value()) << name << ": " << expr.error().reason;
        EXPECT_EQ(expr->node(expr->root()).op, info.op);
    }
    EXPECT_EQ(value_of("sqrt(4)"), 2);
    EXPECT_EQ(value_of("abs(-x)"), 2);
    EXPECT_EQ(value_of("sin(x)"), std::sin(2.0));
    EXPECT_EQ(value_of("cos(x)"), std::cos(2.0));
    EXPECT_EQ(value_of("acos(0.25)"), std::acos(0.25));
    EXPECT_EQ(value_of("atan2(x, y)"), std::atan2(2.0, 3.0));
    EXPECT_EQ(value_of("exp(x)"), std::exp(2.0));
    EXPECT_EQ(value_of("ln(x)"), std::log(2.0));
    EXPECT_EQ(value_of("min(x, y)"), 2);
    EXPECT_EQ(value_of("max(x, y)"), 3);
}

TEST(Parse, TakesMinAndMaxOfMany) {
    EXPECT_EQ(value_of("min(z, y, x, w)"), 2);
    EXPECT_EQ(value_of("max(x, w, y, z)"), 7);
}

struct Refusal {
    std::string_view text;
    std::size_t offset;
    std::string_view in_reason;
};

TEST(Parse, PointsAtWhatIsWrong) {
    const Refusal refusals[] = {
        {"", 0, "no formula"},
        {"   ", 3, "no formula"},
        {"x +", 3, "missing after '+'"},
        {"* x", 0, "missing before '*'"},
        {"x + * y", 4, "missing after '+'"},
        {"x ^", 3, "missing after '^'"},
        {"(x", 0, "not closed"},
        {"x + (y*(z)", 4, "not closed"},
        {"sqrt(x", 4, "not closed"},
        {"x)", 1, "closes nothing"},
        {"()", 1, "missing after '('"},
        {"x = y = z", 6, "second '='"},
        {"= x", 0, "missing before '='"},
        {"x =", 3, "missing after '='"},
        {"x, y", 3, "condition is wanted"},
        {"1 + sqrt(x, y)", 4, "sqrt takes 1 argument, not 2"},
        {"atan2(x)", 0, "atan2 takes 2 arguments, not 1"},
        {"min(x)", 0, "min takes 2 or more arguments, not 1"},
        {"sqrt()", 5, "missing"},
        {"x + foo", 4, "'foo' is not known"},
        {"sqr(x)", 0, "'sqr' is not a function"},
        {"x + 1e301", 4, "too large"},
        {"1e999", 0, "too large"},
        {"x . y", 2, "'.' has no meaning"},
        {"x + \xc3\xa9", 4, "'\xc3\xa9' has no meaning"},
    };
    for (const Refusal& refusal : refusals) {
        const auto expr = parse(refusal.text);
        ASSERT_FALSE(expr.has_value()) << refusal.text;
        EXPECT_EQ(expr.error().offset, refusal.offset) << refusal.text;
        EXPECT_TRUE(expr.error().reason.contains(refusal.in_reason))
            << refusal.text << ": " << expr.error().reason;
    }
}

TEST(Parse, HintsAtTheNearestName) {
    EXPECT_TRUE(parse("sqr(x)").error().hint.contains("sqrt"));
    EXPECT_TRUE(parse("asqrt(x)").error().hint.contains("sqrt"));
    EXPECT_TRUE(parse("x2").error().hint.contains("x*2, x^2 or x_2"));
}

std::string nested(int depth) {
    return std::string(static_cast<std::size_t>(depth), '(') + "x" +
           std::string(static_cast<std::size_t>(depth), ')');
}

// The innermost operand counts as a level, too.
TEST(Parse, LimitsNesting) {
    EXPECT_TRUE(parse(nested(999)).has_value());
    const auto deeper = parse(nested(1000));
    ASSERT_FALSE(deeper.has_value());
    EXPECT_EQ(deeper.error().offset, 1000);
    EXPECT_TRUE(deeper.error().reason.contains("1000"));

    EXPECT_TRUE(parse(std::string(999, '-') + "x").has_value());
    EXPECT_FALSE(parse(std::string(1000, '-') + "x").has_value());
    std::string powers = "x";
    for (int i = 0; i < 1000; ++i)
        powers += "^x";
    EXPECT_FALSE(parse(powers).has_value());
    EXPECT_TRUE(parse(powers.substr(0, 999)).has_value());
}

std::string repeated(std::string_view part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i)
        text += part;
    return text;
}

TEST(Parse, LimitsNestingOfEveryKind) {
    for (const std::string_view opener :
         {"(",         "2(", "x(",  "x{",      "1 + [",    "-(",      "|",    "(|x + ",
          "\\lfloor ", "√",  "∛(",  "\\sqrt",  "\\frac1",  "\\frac{", "sin ", "sin(",
          "sin 2(",    "x^", "x^{", "min(x, ", "{x < 1: ", "if(x < ", "f(x, "}) {
        const auto expr = parse(repeated(opener, static_cast<int>(90'000 / opener.size())));
        ASSERT_FALSE(expr.has_value()) << opener;
        EXPECT_LE(expr.error().offset, 90'000) << opener;
    }
}

/// The deepest texts that the limits allow fit into the stack of a thread.
TEST(Parse, ReadsDeepTextsOnAThread) {
    std::string functions = "f_1(u) = u + 1\n";
    for (int i = 2; i < 990; ++i) {
        const std::string n = std::to_string(i);
        functions += "f_" + n + "(u) = sin(cos(f_" + std::to_string(i - 1) + "(u)))\n";
    }
    const std::jthread thread([&] {
        EXPECT_TRUE(read_program(repeated("x(1 + ", 998) + "x" + repeated(")", 998)));
        EXPECT_TRUE(read_program(repeated("if(x < 1, ", 999) + "x" + repeated(", 2)", 999)));
        EXPECT_TRUE(read_program(repeated("{x < 1: ", 999) + "x" + repeated(", 2}", 999)));
        EXPECT_TRUE(read_program(functions + "f_989(x) = 0"));
        const auto deeper = read_program("f_1(u) = u\n" + repeated("x(1 + ", 998) + "x" +
                                         repeated(")", 998) + functions);
        EXPECT_TRUE(deeper || !deeper.error().reason.empty());
    });
}

TEST(Parse, LimitsTheNodesOfAllSurfaces) {
    std::string text = "a = sum(x^i*y, i, 1, 9999)";
    for (int i = 1; i < 100; ++i)
        text += "; a + z^" + std::to_string(i + 1);
    const auto program = read_program(text);
    ASSERT_FALSE(program.has_value());
    EXPECT_TRUE(program.error().reason.contains("1000000 operations")) << program.error().reason;
}

TEST(Parse, CutsTheReadingOfALongValue) {
    const auto program = read_program("a = sum(x^i*y, i, 1, 500)\na + z = 1");
    ASSERT_TRUE(program.has_value());
    EXPECT_TRUE(program->readings.front().text.starts_with("a = x*y + x^2*y + "));
    EXPECT_TRUE(program->readings.front().text.ends_with("..."));
    EXPECT_LT(program->readings.front().text.size(), 2100);
    EXPECT_TRUE(program->readings.back().text.ends_with(" = 0"));
}

// The exponent is a graph of 70 nodes; a tree of it would have 10^14.
TEST(Parse, TakesExponentsThatShareTheirParts) {
    std::string text = "c_1 = 2\nc_2 = 3\n";
    for (int i = 3; i < 70; ++i) {
        text += "c_" + std::to_string(i) + " = c_" + std::to_string(i - 1) + " - c_" +
                std::to_string(i - 2) + "\n";
    }
    EXPECT_TRUE(read_program(text + "x^c_69 + y = 1"));
}

TEST(Parse, RefusesSumsWhoseIndexIsNoExactNumber) {
    for (const char* const text :
         {"sum(x*i, i, 1e300, 1e300)", "prod(x - i, i, 9007199254740992, 9007199254740993)"}) {
        const auto expr = parse(text);
        ASSERT_FALSE(expr.has_value()) << text;
        EXPECT_TRUE(expr.error().reason.contains("bounds")) << expr.error().reason;
    }
    EXPECT_TRUE(parse("sum(x*i, i, 999999999999999, 1000000000000000)"));
}

TEST(Parse, LimitsTheText) {
    std::string longest(1'999'999, ' ');
    longest.push_back('x');
    EXPECT_TRUE(parse(longest).has_value());
    std::string too_long = longest;
    too_long.push_back(' ');
    const auto longer = parse(too_long);
    ASSERT_FALSE(longer.has_value());
    EXPECT_EQ(longer.error().offset, 2'000'000);
    EXPECT_FALSE(parse(std::string(1'000'000, '(')).has_value());
}

TEST(Parse, TakesAWideFormula) {
    std::string sum = "x";
    while (sum.size() < (test::is_long_run() ? 1'500'000U : 150'000U))
        sum += "+x*y";
    EXPECT_TRUE(parse(sum).has_value());
}

TEST(Parse, SurvivesAnyBytes) {
    test::RandomNumbers random(20);
    constexpr std::string_view usual =
        "xyzw()+-*/^=,.0123456789e sqrtminmaxatan2\xc3\xa9\xf0\x9f%&|!?:;\n_#";
    for (int i = 0; i < 20'000; ++i) {
        std::string text;
        for (std::size_t length = random.below(24); length > 0; --length) {
            text += random.one_in(8) ? static_cast<char>(random.bits() & 0xFFU)
                                     : usual[random.below(usual.size())];
        }
        const auto expr = parse(text);
        if (expr) continue;
        ASSERT_LE(expr.error().offset, text.size()) << text;
        ASSERT_FALSE(expr.error().reason.empty()) << text;
    }
}

// The bytes b2 and b7 are "²" and "·" in Latin-1, but invalid as UTF-8.
TEST(Parse, RefusesBytesThatAreNoCharacter) {
    for (const std::string text : {"1e3\xb2", "x \xb7 y", "x\xc2", "x + \xf0\x9f\x98"}) {
        const auto expr = parse(text);
        ASSERT_FALSE(expr.has_value()) << text;
        EXPECT_TRUE(expr.error().reason.contains("no meaning")) << expr.error().reason;
    }
    EXPECT_FALSE(parse("1e3" + std::string(60, '\xb2') + "0").has_value());
}

TEST(Parse, SurvivesNul) {
    const auto expr = parse(std::string_view("x\0+y", 4));
    ASSERT_FALSE(expr.has_value());
    EXPECT_EQ(expr.error().offset, 1);
}

}  // namespace
}  // namespace zeroset::parse_test
