// Complex numbers in texts, compared with those of the C++ library; where i is no imaginary unit.

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::test::complex_numbers_test {
namespace {

using Number = std::complex<double>;
using Function = std::function<Number(Number)>;

constexpr Number unit(0.0, 1.0);

double value_of(const std::string& text, const std::array<double, 3>& at) {
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << text << ": " << expr.error().reason;
        return NAN;
    }
    return value_at(*expr, {at[0], at[1], at[2], 0.0}).value;
}

/// Functions of c, as they are typed, and their values.
std::vector<std::pair<std::string, Function>> functions_of_c() {
    return {
        {"c^2 - 3 c + 1", [](Number c) { return c * c - 3.0 * c + 1.0; }},
        {"c^5", [](Number c) { return std::pow(c, 5); }},
        {"c^17/100", [](Number c) { return std::pow(c, 17) / 100.0; }},
        {"c^-3", [](Number c) { return std::pow(c, -3); }},
        {"c^(1/2)", [](Number c) { return std::sqrt(c); }},
        {"c^1.7", [](Number c) { return std::pow(c, 1.7); }},
        {"c^c", [](Number c) { return std::pow(c, c); }},
        {"2^c", [](Number c) { return std::pow(2.0, c); }},
        {"e^(i c)", [](Number c) { return std::exp(unit * c); }},
        {"(c + 1)/(c - 2 i)", [](Number c) { return (c + 1.0) / (c - 2.0 * unit); }},
        {"3/c", [](Number c) { return 3.0 / c; }},
        {"-c", [](Number c) { return -c; }},
        {"conj(c)^2", [](Number c) { return std::conj(c) * std::conj(c); }},
        {"exp(c)", [](Number c) { return std::exp(c); }},
        {"ln(c)", [](Number c) { return std::log(c); }},
        {"log(c, 2)", [](Number c) { return std::log(c) / std::log(2.0); }},
        {"sqrt(c)", [](Number c) { return std::sqrt(c); }},
        {"sin(c)", [](Number c) { return std::sin(c); }},
        {"cos(c)", [](Number c) { return std::cos(c); }},
        {"tan(c)", [](Number c) { return std::tan(c); }},
        {"cot(c)", [](Number c) { return 1.0 / std::tan(c); }},
        {"sec(c) + csc(c)", [](Number c) { return 1.0 / std::cos(c) + 1.0 / std::sin(c); }},
        {"sinh(c)", [](Number c) { return std::sinh(c); }},
        {"cosh(c)", [](Number c) { return std::cosh(c); }},
        {"tanh(c)", [](Number c) { return std::tanh(c); }},
        {"sech(c) + csch(c)", [](Number c) { return 1.0 / std::cosh(c) + 1.0 / std::sinh(c); }},
        {"asin(c)", [](Number c) { return std::asin(c); }},
        {"acos(c)", [](Number c) { return std::acos(c); }},
        {"atan(c)", [](Number c) { return std::atan(c); }},
        {"asinh(c)", [](Number c) { return std::asinh(c); }},
        {"acosh(c)", [](Number c) { return std::acosh(c); }},
        {"atanh(c)", [](Number c) { return std::atanh(c); }},
        {"{x > 0: c, 2}", [](Number c) { return c.real() > 0.0 ? c : 2.0; }},
        {"sum(c^k/k, k, 1, 3)", [](Number c) { return c + c * c / 2.0 + c * c * c / 3.0; }},
        {"iterate(q, 3, 0, q^2 + c)", [](Number c) { return std::pow(c * c + c, 2) + c; }},
    };
}

TEST(ComplexNumbers, FunctionsHaveTheLibrarysValues) {
    RandomNumbers random(52);
    for (const auto& [text, function] : functions_of_c()) {
        for (int i = 0; i < 40; ++i) {
            const std::array<double, 3> at{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0),
                                           0.0};
            const Number want = function({at[0], at[1]});
            const double near = 1e-9 * (1.0 + std::abs(want));
            const auto typed = [&](const std::string& part) {
                std::string of = text;
                for (std::size_t k = 0; (k = of.find('c', k)) != std::string::npos; ++k) {
                    const bool letter = (k > 0 && std::isalpha(of[k - 1]) != 0) ||
                                        (k + 1 < of.size() && std::isalpha(of[k + 1]) != 0);
                    if (!letter) of.replace(k, 1, "(x + i y)");
                }
                return part + "(" + of + ")";
            };
            EXPECT_NEAR(value_of(typed("Re"), at), want.real(), near) << text;
            EXPECT_NEAR(value_of(typed("Im"), at), want.imag(), near) << text;
            EXPECT_NEAR(value_of("0*Re(i) + " + typed("abs"), at), std::abs(want), near) << text;
            EXPECT_NEAR(value_of(typed("arg"), at), std::arg(want), 1e-8) << text;
        }
    }
}

/// The graph of `like`, or "" where a text has no surface.
std::string canonical(const std::string& text) {
    const auto program = read_program(text);
    return program ? program->surfaces.back().canonical() : program.error().reason;
}

TEST(ComplexNumbers, AreReadWhereATextAsksForThem) {
    EXPECT_EQ(canonical("z = |x + i y|"), canonical("z = sqrt(x^2 + y^2)"));
    EXPECT_EQ(canonical("z = |x - I y|"), canonical("z = sqrt(x^2 + (-y)^2)"));
    EXPECT_EQ(canonical("c = x + i y; f(q) = q^2; z = Re(f(c))"), canonical("z = x^2 - y^2"));
    EXPECT_EQ(canonical("c = x + i y; z = |c|"), canonical("z = sqrt(x^2 + y^2)"));
    EXPECT_EQ(canonical("z = |y e^(i x)|"), canonical("z = |y|"));
    EXPECT_EQ(canonical("z = \\Re\\left((x + i y)^2\\right)"), canonical("z = x^2 - y^2"));
    EXPECT_EQ(canonical("z = Re[(x + I y)^2]"), canonical("z = x^2 - y^2"));
}

TEST(ComplexNumbers, ElsewhereIIsAParameter) {
    for (const char* const text :
         {"a x^2 + b y^2 + i z = 1", "|x| + i |y| = z", "z = |x - i|", "i = 2; z = |x + i y|",
          "z = |y| + sum(|x + i y|, i, 1, 3)", "f(i) = i^2; z = f(x) + |y|"}) {
        const auto program = read_program(text);
        ASSERT_TRUE(program) << text << ": " << program.error().reason;
        for (const Reading& reading : program->readings) {
            for (const std::string& note : reading.notes)
                EXPECT_FALSE(note.contains("is the imaginary unit") && !note.contains("parameter"))
                    << text << ": " << note;
        }
    }
}

TEST(ComplexNumbers, AreNoRealNumbers) {
    for (const char* const text :
         {"z = Re(x) + i y", "conj(x + i y) = 1", "z = Re(max(x + i y, 1))",
          "z = Im(floor(x + i y))", "z = Re((1, 2, x + i y).x)", "z = Re(sum([x, i y]))",
          "z < Re(1) + i x", "z = Re((x + i y) % 2)", "z = Re((x + i y)*(1, 2, 3))",
          "(u, v, arg(u) + i v), 0 < u < 1, 0 < v < 1"}) {
        const auto program = read_program(text);
        ASSERT_FALSE(program) << text;
        EXPECT_TRUE(program.error().reason.contains("complex"))
            << text << ": " << program.error().reason;
    }
}

}  // namespace
}  // namespace zeroset::test::complex_numbers_test
