#include "engine/rewrite/differences/derivatives.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace zeroset::test::derivatives_test {
namespace {

using Point = std::array<double, 4>;

Expr formula(const char* text) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr.has_value()) << text;
    return *expr;
}

double value(const Expr& expr, const Point& at, const std::vector<double>& parameters = {}) {
    return value_at(expr, at, parameters).value;
}

void expect_curvatures(const char* text, const Point& at, double mean, double gaussian) {
    const Expr f = formula(text);
    EXPECT_NEAR(value(mean_curvature(f), at), mean, 1e-12 * (1.0 + std::abs(mean))) << text;
    EXPECT_NEAR(value(gaussian_curvature(f), at), gaussian, 1e-12 * (1.0 + std::abs(gaussian)))
        << text;
}

TEST(Derivatives, OfASphere) {
    constexpr double r = 2.5;
    for (const auto& [u, v] : {std::pair(0.3, 0.7), std::pair(-1.2, 2.9), std::pair(0.0, 0.0)}) {
        const Point p{r * std::cos(u) * std::cos(v), r * std::cos(u) * std::sin(v), r * std::sin(u),
                      0};
        expect_curvatures("x^2 + y^2 + z^2 - 6.25", p, 1 / r, 1 / (r * r));
        expect_curvatures("sqrt(x^2 + y^2 + z^2) - 2.5", p, 1 / r, 1 / (r * r));
        // The other side: the mean curvature changes its sign.
        expect_curvatures("6.25 - x^2 - y^2 - z^2", p, -1 / r, 1 / (r * r));
    }
}

TEST(Derivatives, OfACylinderAndAPlane) {
    expect_curvatures("x^2 + z^2 - 4", {1.2, -3, 1.6, 0}, 0.25, 0);
    expect_curvatures("x + 2y - 3z", {1, 1, 1, 0}, 0, 0);
    expect_curvatures("z", {1, 1, 0, 0}, 0, 0);
}

TEST(Derivatives, OfATorus) {
    constexpr double big = 2.0;
    constexpr double small = 0.5;
    for (const double theta : {0.0, 0.8, 2.0, std::numbers::pi}) {
        for (const double phi : {0.1, 2.2}) {
            const double rho = big + small * std::cos(theta);
            const Point p{rho * std::cos(phi), rho * std::sin(phi), small * std::sin(theta), 0};
            const double k1 = 1 / small;
            const double k2 = std::cos(theta) / rho;
            expect_curvatures("(sqrt(x^2 + y^2) - 2)^2 + z^2 - 0.25", p, 0.5 * (k1 + k2), k1 * k2);
            expect_curvatures("(x^2 + y^2 + z^2 + 3.75)^2 - 16(x^2 + y^2)", p, 0.5 * (k1 + k2),
                              k1 * k2);
        }
    }
}

TEST(Derivatives, OfASaddle) {
    for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(0.5, -1.5), std::pair(1.0, 2.0)}) {
        const double square = 1 + x * x + y * y;
        expect_curvatures("z - x y", {x, y, x * y, 0}, x * y / std::pow(square, 1.5),
                          -1 / (square * square));
    }
}

TEST(Derivatives, OfAMinimalSurface) {
    // A catenoid: no mean curvature anywhere.
    const double z = 0.4;
    const double r = std::cosh(z);
    expect_curvatures("x^2 + y^2 - cosh(z)^2", {r * std::cos(1.0), r * std::sin(1.0), z, 0}, 0,
                      -1 / std::pow(r, 4));
}

TEST(Derivatives, FollowTheBranchOfAChoice) {
    const char* const text = "min(x^2 + y^2 + z^2 - 1, (x-3)^2 + y^2 + z^2 - 4)";
    expect_curvatures(text, {-1, 0, 0, 0}, 1, 1);
    expect_curvatures(text, {5, 0, 0, 0}, 0.5, 0.25);
    expect_curvatures("abs(x) - 1", {-1, 0.5, 2, 0}, 0, 0);
    expect_curvatures("x^2 + y^2 - 1, z < 0", {1, 0, -1, 0}, 0.5, 0);
    EXPECT_TRUE(std::isnan(value(mean_curvature(formula("x^2 + y^2 - z^2")), {0, 0, 0, 0})));
}

TEST(Derivatives, HaveParametersAndW) {
    const auto program = read_program("x^2 + y^2 + z^2 = (a + w)^2; b x = 1");
    ASSERT_TRUE(program.has_value());
    ASSERT_EQ(program->parameters, (std::vector<std::string>{"a", "b"}));
    const Expr mean = mean_curvature(program->surfaces[0]);
    EXPECT_EQ(mean.parameters().size(), 2U);
    EXPECT_NEAR(value(mean, {0, 0, 5, 3}, {2, 7}), 0.2, 1e-15);
    EXPECT_DOUBLE_EQ(value(gradient_size(program->surfaces[1]), {1, 1, 1, 0}, {2, -7}), 7.0);
}

TEST(Derivatives, OfAllFunctionsAreThoseOfTheGradient) {
    // The second derivative of f by x, by the graph, against differences of the first.
    constexpr double h = 1e-5;
    for (const char* const text :
         {"sin(x) + y", "cos(x y)",     "tan(x) z",    "cot(x)",    "asin(x/3)",
          "acos(x/3)",  "atan(x z)",    "atan2(y, x)", "exp(x y)",  "ln(x)",
          "log10(x)",   "log2(x)",      "sinh(x)",     "cosh(x)",   "tanh(x)",
          "asinh(x)",   "acosh(x + 1)", "atanh(x/3)",  "sqrt(x)",   "cbrt(x)",
          "x^(1/5)",    "mod(x, y)^2",  "x^-3",        "x/(y + x)", "sin(3 atan2(y, x))"}) {
        const Expr f = formula(text);
        const Expr size = gradient_size(f);
        const Point p{0.7, 1.3, 0.4, 0};
        const Dual<double> by_graph = value_at(size, p);
        const auto length_at = [&](double x) {
            const Dual<double> at = value_at(f, {x, p[1], p[2], p[3]});
            double square = 0;
            for (std::size_t i = 0; i < 3; ++i)
                square += at.slope[i].value_or(0.0) * at.slope[i].value_or(0.0);
            return std::sqrt(square);
        };
        EXPECT_NEAR(by_graph.value, length_at(p[0]), 1e-13 * (1 + by_graph.value)) << text;
        const double slope = (length_at(p[0] + h) - length_at(p[0] - h)) / (2 * h);
        EXPECT_NEAR(by_graph.slope[0].value_or(0.0), slope, 1e-7 * (1 + std::abs(slope))) << text;
    }
}

TEST(PointFunctions, GiveTheValuesOfKernels) {
    RandomNumbers random(7);
    for (int i = 0; i < 30; ++i) {
        const Expr expr = random_expression(random, 4);
        constexpr std::size_t size = batch_multiple;
        std::array<std::array<double, size>, 3> x{};
        for (auto& column : x) {
            for (double& item : column)
                item = random.uniform(-2.0, 2.0);
        }
        Uniforms uniforms;
        uniforms.set(0, 0.5);
        std::array<double, size> alone{};
        std::array<double, size> whole{};
        std::array<std::array<double, size>, 3> gradient{};
        ValueBatchOf<double> batch{size,
                                   {x[0].data(), x[1].data(), x[2].data()},
                                   uniforms.points<double>(),
                                   alone.data(),
                                   {}};
        const UpwardRounding upward;
        interpret_points(expr)(batch);
        batch.f = whole.data();
        for (std::size_t k = 0; k < 3; ++k)
            batch.gradient[k] = gradient[k].data();
        interpret(expr).value(batch);
        for (std::size_t k = 0; k < size; ++k) {
            const bool same =
                alone[k] == whole[k] || (std::isnan(alone[k]) && std::isnan(whole[k]));
            EXPECT_TRUE(same) << expr.canonical();
        }
    }
}

}  // namespace
}  // namespace zeroset::test::derivatives_test
