// Polynomials with names, compared with those of the C++ library.

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace zeroset::test::polynomials_test {
namespace {

using Function = std::function<double(double, double)>;

/// Compares a text at some x and y.
void expect_value(const std::string& text, const Function& want) {
    const auto expr = parse(text);
    ASSERT_TRUE(expr) << text << ": " << expr.error().reason;
    for (const double x : {-0.9, -0.31, 0.0, 0.47, 1.0}) {
        for (const double y : {-2.0, 0.3, 1.7}) {
            const double value = want(x, y);
            EXPECT_NEAR(value_at(*expr, {x, y, 0.0, 0.0}).value, value,
                        1e-7 * (1.0 + std::abs(value)))
                << text << " at " << x << ", " << y;
        }
    }
}

TEST(Polynomials, HaveTheLibrarysValues) {
    for (unsigned n = 0; n <= 12; ++n) {
        const std::string degree = std::to_string(n);
        expect_value("legendre(" + degree + ", x)",
                     [n](double x, double) { return std::legendre(n, x); });
        expect_value("hermite(" + degree + ", x)",
                     [n](double x, double) { return std::hermite(n, x); });
        expect_value("laguerre(" + degree + ", x + 1)",
                     [n](double x, double) { return std::laguerre(n, x + 1.0); });
        expect_value("laguerre(" + degree + ", 2, x + 1)",
                     [n](double x, double) { return std::assoc_laguerre(n, 2, x + 1.0); });
        expect_value("chebyshev(" + degree + ", cos(y))",
                     [n](double, double y) { return std::cos(n * y); });
        for (unsigned m = 0; m <= n; ++m) {
            expect_value("legendre(" + degree + ", " + std::to_string(m) + ", x)",
                         [n, m](double x, double) {
                             return (m % 2 == 0 ? 1.0 : -1.0) * std::assoc_legendre(n, m, x);
                         });
        }
    }
}

TEST(Polynomials, SphericalHarmonicsHaveTheLibrarysValues) {
    for (int l = 0; l <= 9; ++l) {
        for (int m = -l; m <= l; ++m) {
            const std::string call = "spherical_harmonic(" + std::to_string(l) + ", " +
                                     std::to_string(m) + ", acos(x), y)";
            const double sign = m < 0 && m % 2 != 0 ? -1.0 : 1.0;
            const auto length = [l, m, sign](double x) {
                const auto order = static_cast<unsigned>(std::abs(m));
                return sign * std::sph_legendre(static_cast<unsigned>(l), order, std::acos(x));
            };
            expect_value("Re(" + call + ")",
                         [&](double x, double y) { return length(x) * std::cos(m * y); });
            expect_value("Im(" + call + ")",
                         [&](double x, double y) { return length(x) * std::sin(m * y); });
            expect_value("abs(" + call + ")",
                         [&](double x, double) { return std::abs(length(x)); });
        }
    }
}

TEST(Polynomials, OtherFunctionsHaveTheirValues) {
    expect_value("sinc(x + 3)", [](double x, double) { return std::sin(x + 3.0) / (x + 3.0); });
    expect_value("heaviside(y)", [](double, double y) { return y < 0.0 ? 0.0 : 1.0; });
    expect_value("5! x", [](double x, double) { return 120.0 * x; });
}

TEST(Polynomials, RefuseWhatIsNoDegree) {
    for (const char* const text :
         {"legendre(21, x)", "hermite(-1, x)", "laguerre(1.5, x)", "legendre(2, 3, x)",
          "chebyshev(x, y)", "spherical_harmonic(2, 3, x, y)", "spherical_harmonic(10, 0, x, y)"}) {
        const auto expr = parse(text);
        ASSERT_FALSE(expr) << text;
        EXPECT_TRUE(expr.error().reason.contains("whole numbers")) << expr.error().reason;
    }
}

}  // namespace
}  // namespace zeroset::test::polynomials_test
