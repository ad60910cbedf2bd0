// Special functions in texts: values beside those of the C++ library, slopes, where they are not
// defined.

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/rewrite/differences/derivatives.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace zeroset::test::special_functions_test {
namespace {

struct Known {
    std::string text;
    std::function<double(double)> function;
    std::vector<double> at;
};

std::vector<Known> all_known() {
    const std::vector<double> right{0.1, 0.9, 1.0, 2.5, 7.0, 11.25};
    const std::vector<double> both{-4.3, -2.5, -0.4, 0.3, 1.0, 2.5, 7.25};
    return {
        {"erf(x)", [](double x) { return std::erf(x); }, both},
        {"erfc(x)", [](double x) { return std::erfc(x); }, both},
        {"gamma(x)", [](double x) { return std::tgamma(x); }, both},
        {"factorial(x)", [](double x) { return std::tgamma(x + 1); }, both},
        {"lgamma(x)", [](double x) { return std::lgamma(x); }, both},
        {"loggamma(x)", [](double x) { return std::lgamma(x); }, right},
        {"beta(x, 2.5)", [](double x) { return std::beta(x, 2.5); }, right},
        {"zeta(x)", [](double x) { return std::riemann_zeta(x); }, both},
        {"j0(x)", [](double x) { return std::cyl_bessel_j(0, x); }, right},
        {"jn(-3, x)", [](double x) { return -std::cyl_bessel_j(3, x); }, right},
        {"bessely(2, x)", [](double x) { return std::cyl_neumann(2, x); }, right},
        {"besseli(2, x)", [](double x) { return std::cyl_bessel_i(2, x); }, right},
        {"besselk(2, x)", [](double x) { return std::cyl_bessel_k(2, x); }, right},
        // Inverse functions and recurrences
        {"lambertw(x exp(x))", [](double x) { return x; }, right},
        {"digamma(x + 1) - digamma(x)", [](double x) { return 1 / x; }, both},
        {"besselj(1, -x) + besselj(1, x)", [](double) { return 0.0; }, right},
    };
}

TEST(SpecialFunctions, HaveTheLibrarysValues) {
    for (const Known& known : all_known()) {
        const auto expr = parse(known.text);
        ASSERT_TRUE(expr) << known.text << ": " << expr.error().reason;
        for (const double x : known.at) {
            if (known.text == "zeta(x)" && x == 1) continue;
            const double want = known.function(x);
            EXPECT_NEAR(value_at(*expr, {x, 0, 0, 0}).value, want, 1e-11 * (1 + std::abs(want)))
                << known.text << " at " << x;
        }
    }
}

/// The first and the second derivative, as formulas, beside differences.
TEST(SpecialFunctions, HaveDerivatives) {
    for (const Known& known : all_known()) {
        const auto expr = parse(known.text);
        ASSERT_TRUE(expr) << known.text;
        const Expr first = gradient_of(*expr)[0];
        const Expr second = gradient_of(first)[0];
        for (const double x : known.at) {
            constexpr double step = 1e-4;
            if (known.text == "zeta(x)" && x == 1) continue;
            const double here = known.function(x);
            const double before = known.function(x - step);
            const double behind = known.function(x + step);
            const double slope = (behind - before) / (2 * step);
            const double bend = (behind - 2 * here + before) / (step * step);
            const double near = 1e-4 * (1 + std::abs(here) + std::abs(slope) + std::abs(bend));
            EXPECT_NEAR(value_at(first, {x, 0, 0, 0}).value, slope, near) << known.text << x;
            EXPECT_NEAR(value_at(second, {x, 0, 0, 0}).value, bend, near) << known.text << x;
        }
    }
}

TEST(SpecialFunctions, AreUndefinedAtPolesAndBeyondTheirDomains) {
    for (const auto& [text, x] :
         std::vector<std::pair<std::string, double>>{{"gamma(x)", 0},
                                                     {"gamma(x)", -3},
                                                     {"lgamma(x)", -2},
                                                     {"loggamma(x)", -0.5},
                                                     {"digamma(x)", 0},
                                                     {"zeta(x)", 1},
                                                     {"lambertw(x)", -0.4},
                                                     {"bessely(0, x)", 0},
                                                     {"besselk(1, x)", -1}}) {
        const auto expr = parse(text);
        ASSERT_TRUE(expr) << text;
        EXPECT_FALSE(std::isfinite(value_at(*expr, {x, 0, 0, 0}).value)) << text << " at " << x;
    }
}

}  // namespace
}  // namespace zeroset::test::special_functions_test
