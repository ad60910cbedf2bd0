// Quotients that are 0/0 and have a limit: the same values elsewhere, their limits there, in proved
// enclosures.

#include "engine/rewrite/differences/removable_poles.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace zeroset::test::removable_poles_test {
namespace {

double value_of(const Expr& expr, double x, double y) {
    return value_at(expr, {x, y, 0.0, 0.0}).value;
}

/// A quotient, and its limit at a place where it is 0/0.
struct Quotient {
    const char* text;
    double x, y, limit;
};

constexpr std::array quotients{
    Quotient{"sin(x)/x", 0.0, 0.3, 1.0},
    Quotient{"sin(x*y)/(x*y)", 0.0, 1.2, 1.0},
    Quotient{"sin(3*x)/x", 0.0, 0.3, 3.0},
    Quotient{"sin(sqrt(x^2 + y^2))/sqrt(x^2 + y^2)", 0.0, 0.0, 1.0},
    Quotient{"x/sin(x)", 0.0, 0.3, 1.0},
    Quotient{"x/(exp(x) - 1)", 0.0, 0.3, 1.0},
    Quotient{"(exp(x) - exp(y))/(x - y)", 0.5, 0.5, 0x1.a61298e1e069cp+0},
    Quotient{"(cos(x) - cos(y))/(y - x)", 0.5, 0.5, 0x1.eaee8744b05f0p-2},
    Quotient{"(sin(x)^2 - sin(y)^2)/(x - y)", 0.5, 0.5, 0x1.aed548f090ceep-1},
    Quotient{"(x^3 - y^3)/(x - y)", 0.5, 0.5, 0.75},
    Quotient{"(x^5 - 1)/(x - 1)", 1.0, 0.2, 5.0},
    Quotient{"(sqrt(x) - sqrt(y))/(x - y)", 0.25, 0.25, 1.0},
    Quotient{"(1 - cos(x))/x^2", 0.0, 0.2, 0.5},
    Quotient{"(1 - cos(x))/x", 0.0, 0.2, 0.0},
    Quotient{"tan(x)/x", 0.0, 0.2, 1.0},
    Quotient{"tanh(x)/x", 0.0, 0.2, 1.0},
    Quotient{"sinh(x - y)/(x - y)", 0.7, 0.7, 1.0},
    Quotient{"atan(x)/x", 0.0, 0.2, 1.0},
    Quotient{"sin(x)*sin(y)/(x*y)", 0.0, 0.0, 1.0},
    Quotient{"(ln(x) - ln(y))/(x - y)", 0.5, 0.5, 2.0},
    Quotient{"(ln(3*x) - ln(3*y))/(x - y)", 0.5, 0.5, 2.0},
    Quotient{"(x - y)/(ln(x) - ln(y))", 0.5, 0.5, 0.5},
    Quotient{"ln(x)/(x - 1)", 1.0, 0.2, 1.0},
    Quotient{"(log10(x) - log10(y))/(x - y)", 0.5, 0.5, 0.86858896380650365},
    Quotient{"(log2(x) - log2(y))/(x - y)", 0.5, 0.5, 2.8853900817779268},
    Quotient{"(x*ln(x) - y*ln(y))/(x - y)", 0.5, 0.5, 0.30685281944005469},
    Quotient{"(x^0.3 - y^0.3)/(x - y)", 0.5, 0.5, 0.48735143781374},
    Quotient{"(asin(x) - asin(y))/(x - y)", 0.5, 0.5, 1.1547005383792515},
    Quotient{"(acos(x) - acos(y))/(x - y)", 0.5, 0.5, -1.1547005383792515},
    Quotient{"(asinh(x) - asinh(y))/(x - y)", 0.5, 0.5, 0.89442719099991588},
    Quotient{"(atan(3*x) - atan(3*y))/(x - y)", 0.5, 0.5, 0.92307692307692313},
    Quotient{"(atanh(x/2) - atanh(y/2))/(x - y)", 0.5, 0.5, 0.53333333333333333},
    Quotient{"(acosh(x + 2) - acosh(y + 2))/(x - y)", 0.5, 0.5, 0.43643578047198475},
    Quotient{"(x^2 - 4)/(x - 2) + y", 2.0, 1.0, 5.0},
    Quotient{"(exp(x*ln(x + y)) - 1)/x", 0.0, 0.5, -0x1.62e42fefa39efp-1},
    Quotient{"((1 + x*sqrt(x + y))^2 - 1)/x", 0.0, 0.25, 1.0},
};

TEST(RemovablePoles, HaveTheirLimits) {
    for (const auto& [text, x, y, limit] : quotients) {
        const Expr written = without_removable_poles(*parse(text)).value_or(*parse(text));
        EXPECT_NEAR(value_of(written, x, y), limit, 1e-12) << text << " as " << written.canonical();
    }
}

TEST(RemovablePoles, LeaveAllOtherValues) {
    RandomNumbers random(14);
    for (const Quotient& quotient : quotients) {
        const Expr typed = *parse(quotient.text);
        const Expr written = without_removable_poles(typed).value_or(typed);
        for (int i = 0; i < 200; ++i) {
            const double x = random.uniform(-1.4, 1.4);
            const double y = random.uniform(-1.4, 1.4);
            const double value = value_of(typed, x, y);
            const double other = value_of(written, x, y);
            ASSERT_EQ(std::isnan(value), std::isnan(other)) << quotient.text << " at " << x << y;
            if (std::isnan(value)) continue;
            ASSERT_NEAR(other, value, 1e-9 * (1.0 + std::abs(value)) / std::abs(x * y * (x - y)))
                << quotient.text << " at " << x << ", " << y;
        }
    }
}

TEST(RemovablePoles, StayWhereThereIsNoLimit) {
    for (const char* const text :
         {"1/x", "cos(x)/x", "x*y/(x^2 + y^2)", "(exp(x) - exp(-y))/(x - y)", "(x^2 + y^2)/(x - y)",
          "floor(x)/x", "abs(x)/x", "sin(x)/x^2", "x*y/(x*(1 + y^2))", "x/3"}) {
        const Expr typed = *parse(text);
        const Expr written = without_removable_poles(typed).value_or(typed);
        const double there = value_of(written, 0.0, 0.0);
        EXPECT_TRUE(!std::isfinite(there) || std::string(text) == "x/3") << text << ": " << there;
    }
}

}  // namespace
}  // namespace zeroset::test::removable_poles_test
