// Hostile texts are refused quickly, with a one-line message and without deep recursion.

#include "engine/language/parse.hpp"
#include "tests/support/long_run.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace zeroset::limits_test {
namespace {

std::string repeated(std::string_view text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i)
        result += text;
    return result;
}

/// Concatenates line("0"), line("1"), ..., line(count - 1), each with a line break.
std::string lines(int count, const std::function<std::string(std::string)>& line) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += line(std::to_string(i)) + "\n";
    return result;
}

/// Concatenates line(i, i - 1) for i = 1, ..., count - 1, each with a line break.
std::string chain(int count, const std::function<std::string(std::string, std::string)>& line) {
    std::string result;
    for (int i = 1; i < count; ++i)
        result += line(std::to_string(i), std::to_string(i - 1)) + "\n";
    return result;
}

void expect_refused(const std::string& text, std::string_view words) {
    const auto program = read_program(text);
    ASSERT_FALSE(program.has_value()) << text.substr(0, 80);
    const ParseError& error = program.error();
    EXPECT_TRUE(error.reason.contains(words)) << error.reason << "\n" << text.substr(0, 80);
    EXPECT_LE(error.reason.size() + error.hint.size(), 300) << text.substr(0, 80);
    EXPECT_LE(error.offset, text.size());
}

void expect_read(const std::string& text) {
    const auto program = read_program(text);
    EXPECT_TRUE(program.has_value()) << text.substr(0, 80) << ": " << program.error().reason;
}

/// Repeats `text` up to `size` bytes, between `before` and `behind`.
std::string text_of_size(std::size_t size, std::string_view text, std::string_view before,
                         std::string_view behind) {
    return std::string(before) + repeated(text, static_cast<int>(size / text.size())) +
           std::string(behind);
}

TEST(Limits, Nesting) {
    for (const char* const opener :
         {"(",       "[",      "{",       "(x",      "{x",      "|",       "(|",
          "x^",      "x(",     "sin ",    "sin(",    "√",       "2√",      "√(",
          "\\sqrt{", "\\sqrt", "\\sqrt ", "\\sqrt[", "\\frac ", "\\frac{", "\\frac x",
          "⌊",       "not (",  "if(",     "if(x<",   "{x<1:",   "max(x,",  "sum(",
          "log_2 ",  "-(",     "x-",      "x/(",     "f(",      "|x+"}) {
        const std::string text =
            repeated(opener, 99'000 / static_cast<int>(std::string(opener).size()));
        const auto program = read_program(text + "x");
        if (program) continue;
        EXPECT_LE(program.error().reason.size(), 300);
    }
    expect_refused(repeated("√", 33'000) + "x", "1000");
    expect_refused(repeated("(x", 40'000), "1000");
    expect_refused(repeated("\\frac ", 16'000) + "x", "1000");
    expect_refused(repeated("\\sqrt ", 16'000) + "x", "1000");
    expect_refused(repeated("-", 99'000) + "x", "1000");
    expect_read(repeated("(", 999) + "x" + repeated(")", 999));
    expect_read(repeated("(1 + 2*", 990) + "x" + repeated(")", 990));
    expect_read(repeated("if(x < 0, ", 990) + "x" + repeated(", y)", 990));
}

TEST(Limits, CasesInCases) {
    const auto nested = [](int times) {
        return "z = " + repeated("\\begin{cases} 1 & x < 0 \\\\ ", times) + "y" +
               repeated("\\end{cases}", times);
    };
    expect_read(nested(100));
    expect_refused(nested(101), "nested more than 100 deep");
    expect_refused(nested(30'000), "nested more than 100 deep");
}

TEST(Limits, Text) {
    expect_refused(repeated("x", 2'000'001), "2000000");
    if (test::is_long_run()) {
        expect_read(repeated("x", 900'000));
        expect_refused(repeated("x", 2'000'000), "1000000 operations");
    }
    expect_refused(repeated("foo", 33'000), "not known");
    expect_refused(repeated("x²³", 9'000) + repeated("²", 5'000), "too large");
    expect_refused("x + " + repeated("1", 90'000), "too large");
    expect_refused("\\" + repeated("a", 90'000), "LaTeX");
    expect_refused("x " + repeated("1", 90'000) + " 2", "operator is missing");
    expect_refused(repeated("\xC3", 5'000), "byte 195");
    expect_refused(std::string(5'000, '\0'), "byte 0");
}

TEST(Limits, Counts) {
    expect_read(lines(100'000 - 1, [](const auto& i) { return "a_" + i + " = 1"; }) + "x");
    expect_refused(lines(100'000, [](const auto& i) { return "a_" + i + " = 1"; }) + "x", "100000");
    expect_read(lines(100, [](const auto& i) { return "x = " + i; }));
    expect_refused(lines(101, [](const auto& i) { return "x = " + i; }), "100 surfaces");
    expect_read("x" + lines(200, [](const auto& i) { return " + a_" + i; }));
    expect_refused("x" + lines(201, [](const auto& i) { return " + a_" + i; }), "200 parameters");
    expect_read("sum(x^i, i, 1, 10000)");
    expect_refused("sum(x^i, i, 0, 10000)", "10 000 terms");
    expect_refused("prod(x - i, i, -9e14, 9e14)", "10 000 terms");
    expect_refused("sum(sum(x^i + y^j, i, 1, 1000), j, 1, 1000)", "1000000");
    expect_refused("sum(sum(sum(sum(x, i, 1, 9999), j, 1, 9999), k, 1, 9999), l, 1, 9999)",
                   "too many");
}

// Definitions whose expansion doubles with each line are small as graphs but not as text.
TEST(Limits, Doubling) {
    const auto doubling = [](const auto& i, const auto& j) {
        return "f_" + i + "(u) = f_" + j + "(u) + f_" + j + "(u + 1)";
    };
    expect_read("f_0(u) = u^2\n" + chain(60, doubling) + "f_59(x)");
    if (test::is_long_run())
        expect_refused("f_0(u) = u^2\n" + chain(1'600, doubling) + "f_1599(x)", "1000000");
    expect_read(
        "a_0 = x\n" +
        chain(900, [](const auto& i,
                      const auto& j) { return "a_" + i + " = a_" + j + " + sin(a_" + j + ")"; }) +
        "a_899");
    // The parser computes exact values for exponents.
    expect_read("a_0 = 1 - 1\n" +
                chain(200, [](const auto& i,
                              const auto& j) { return "a_" + i + " = a_" + j + " - a_" + j; }) +
                "x + 2^a_199");
}

// Long chains of definitions need no deep recursion, in either order of the lines.
TEST(Limits, Chains) {
    const auto next = [](const auto& i, const auto& j) { return "a_" + i + " = a_" + j + " + x"; };
    expect_read("a_0 = x\n" + chain(50'000, next) + "a_49999");
    expect_read("a_49999\n" + chain(50'000, next) + "a_0 = x");
    const auto redefined = [](const auto& i) { return "a = a + " + i; };
    expect_read("a = x\n" + lines(50'000, redefined) + "a");
    const auto by_row = [](const auto& i, const auto& j) { return "s_" + i + " = u + s_" + j; };
    expect_read("s_0 = v\n" + chain(2'000, by_row) + "(u, s_1999, v), 0 < u < 1, 0 < v < 1");
    const auto instruction = [](const auto& i, const auto& j) {
        return "b" + i + " max b" + j + " b0";
    };
    expect_read("b0 var-x\nb1 var-y\n" + chain(50'000, instruction));
    std::string joined = "y < 0";
    for (int i = 0; i < 40'000; ++i)
        joined += " or x < " + std::to_string(i);
    expect_read(joined);
}

TEST(Limits, ATextThatRepeatsAnyPartIsReadOrRefused) {
    // In a long run a step that takes quadratic time needs longer than ctest waits.
    const std::size_t size = test::is_long_run() ? 150'000 : 15'000;
    for (const char* const part :
         {"x",      "(",     "|",     "x|",     "x||",   "(a|",         "x>1|",       "x|&|",
          "f(",     "-",     "!",     "x<0?1:", "x<0?",  "1,2,",        "1,5+",       "a1",
          "x_1",    "_a",    "sinxa", "foo",    "x:",    "a:b;",        ";",          "\n",
          "a(b)=",  "a=b\n", "x+",    "x%2+",   "1.f+",  "/*a*/",       "x//y\n",     "\n+x",
          "np.",    "sin ",  "{x<1:", "x{x<1}", "x==",   "x<",          "²",          "cx=1\n",
          "xy=x\n", "r=1\n", "r=x\n", "a=a\n",  "[{(",   "f(u)=f(u)\n", "float a=1,", "a\\\n",
          "sum(",   "x^",    "√",     "0,0,",   "a b c "}) {
        for (const auto& [before, behind] :
             {std::pair{"", ""}, std::pair{"", "x"}, std::pair{"a1 = 2; x = ", "1"},
              std::pair{"max(", "x)"}, std::pair{"float f(float u) {", "return u; } f(x)"}}) {
            const auto program = read_program(text_of_size(size, part, before, behind));
            const std::size_t said = program ? 0 : program.error().reason.size();
            EXPECT_LE(said, 300) << before << part << behind;
        }
    }
}

TEST(Limits, ManyNames) {
    std::string arguments = "a_0";
    for (int i = 1; i < 7'000; ++i)
        arguments += ",a_" + std::to_string(i);
    expect_refused("f(" + arguments + ") = a_0" + repeated("+a_0", 6'000) + "\nsum(f(i" +
                       repeated(",1", 6'999) + "), i, 1, 1000)",
                   "too many");
}

TEST(Limits, Readings) {
    const std::string large = "a = sum(sin(x + i), i, 1, 9999)\n";
    const auto functions = read_program(
        large + lines(990, [](const auto& i) { return "f_" + i + "(u) = a + u"; }) + "a");
    ASSERT_TRUE(functions.has_value());
    const auto many = read_program(
        large + lines(50'000, [](const auto& i) { return "f_" + i + "(u) = a + u"; }) + "a");
    ASSERT_TRUE(many.has_value());
    const auto surfaces = read_program("a = sum(sin(x + i), i, 1, 400)\n" +
                                       lines(100, [](const auto& i) { return "a+" + i; }));
    ASSERT_TRUE(surfaces.has_value());
    for (const auto& program : {functions, many, surfaces}) {
        std::size_t total = 0;
        for (const Reading& reading : program->readings)
            total += reading.text.size();
        EXPECT_LE(total, 6'000'000);
    }
}

}  // namespace
}  // namespace zeroset::limits_test
