#include "engine/num/dual.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace zeroset::test::dual_test {
namespace {

using Vector = std::array<double, 3>;

Dual<double> at(const char* text, const Vector& point) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr.has_value()) << text;
    return value_at(*expr, {point[0], point[1], point[2], 0.5});
}

void expect_gradient(const char* text, const Vector& point, const Vector& expected) {
    const Dual<double> found = at(text, point);
    for (std::size_t i = 0; i < 3; ++i) {
        const double slope = found.slope[i].value_or(0.0);
        EXPECT_NEAR(slope, expected.at(i), 1e-14 * (1 + std::abs(expected.at(i))))
            << "df/d" << "xyz"[i] << " of " << text;
    }
}

TEST(Dual, HasTheGradientsOfClosedForms) {
    constexpr double x = 0.7;
    constexpr double y = -1.3;
    constexpr double z = 2.1;
    const Vector p{x, y, z};
    expect_gradient("x + 2*y - z", p, {1, 2, -1});
    expect_gradient("-x", p, {-1, 0, 0});
    expect_gradient("x*y*z", p, {y * z, x * z, x * y});
    expect_gradient("x/y", p, {1 / y, -x / (y * y), 0});
    expect_gradient("x^2", p, {2 * x, 0, 0});
    expect_gradient("y^7", p, {0, 7 * std::pow(y, 6), 0});
    expect_gradient("x^-2", p, {-2 / (x * x * x), 0, 0});
    expect_gradient("sqrt(z)", p, {0, 0, 0.5 / std::sqrt(z)});
    expect_gradient("abs(y)", p, {0, -1, 0});
    expect_gradient("abs(x)", p, {1, 0, 0});
    expect_gradient("sin(y)", p, {0, std::cos(y), 0});
    expect_gradient("cos(y)", p, {0, -std::sin(y), 0});
    expect_gradient("acos(x)", p, {-1 / std::sqrt(1 - x * x), 0, 0});
    expect_gradient("exp(y)", p, {0, std::exp(y), 0});
    expect_gradient("ln(z)", p, {0, 0, 1 / z});
    expect_gradient("log10(z)", p, {0, 0, std::numbers::log10e / z});
    expect_gradient("log2(z)", p, {0, 0, std::numbers::log2e / z});
    expect_gradient("tan(y)", p, {0, 1 + std::tan(y) * std::tan(y), 0});
    expect_gradient("cot(x)", p, {-1 / (std::sin(x) * std::sin(x)), 0, 0});
    expect_gradient("asin(x)", p, {1 / std::sqrt(1 - x * x), 0, 0});
    expect_gradient("atan(y)", p, {0, 1 / (1 + y * y), 0});
    expect_gradient("sinh(y)", p, {0, std::cosh(y), 0});
    expect_gradient("cosh(y)", p, {0, std::sinh(y), 0});
    expect_gradient("tanh(y)", p, {0, 1 / (std::cosh(y) * std::cosh(y)), 0});
    expect_gradient("asinh(y)", p, {0, 1 / std::sqrt(1 + y * y), 0});
    expect_gradient("acosh(z)", p, {0, 0, 1 / std::sqrt(z * z - 1)});
    expect_gradient("atanh(x)", p, {1 / (1 - x * x), 0, 0});
    expect_gradient("mod(z, x)", p, {-3, 0, 1});
    expect_gradient("mod(y, z)", p, {0, 1, 1});
    expect_gradient("if(y > 0, x, z)", p, {0, 0, 1});
    expect_gradient("if(x > 0, x, z)", p, {1, 0, 0});
    expect_gradient("atan2(y, x)", p, {-y / (x * x + y * y), x / (x * x + y * y), 0});
    expect_gradient("min(x*2, y)", p, {0, 1, 0});
    expect_gradient("max(x*2, y)", p, {2, 0, 0});
    expect_gradient("z^x", p, {std::pow(z, x) * std::log(z), 0, x * std::pow(z, x - 1)});
    expect_gradient("w*x", p, {0.5, 0, 0});
}

TEST(Dual, HasNoSlopeAlongWhatIsAbsent) {
    const Dual<double> found = at("x^2 + sin(x)", {1, 2, 3});
    EXPECT_TRUE(found.slope[0].has_value());
    EXPECT_FALSE(found.slope[1].has_value());
    EXPECT_FALSE(found.slope[2].has_value());
    EXPECT_FALSE(at("w + 3", {1, 2, 3}).slope[0].has_value());
}

TEST(Dual, TakesTheSlopeOfTheChosenOperand) {
    const Dual<double> smaller = at("min(x, 2)", {1, 0, 0});
    const Dual<double> constant = at("min(x, 2)", {3, 0, 0});
    EXPECT_EQ(smaller.slope[0], 1.0);
    EXPECT_EQ(constant.slope[0], 0.0);
}

TEST(Dual, HasNoSlopeOnSteps) {
    for (const char* const text : {"floor(x)", "ceil(x)", "round(x)", "sign(x)"})
        EXPECT_FALSE(at(text, {0.3, 0, 0}).slope[0].has_value()) << text;
    EXPECT_EQ(at("round(x)", {-2.5, 0, 0}).value, -2);
    EXPECT_EQ(at("round(x)", {2.5, 0, 0}).value, 3);
    EXPECT_EQ(at("sign(x)", {-0.1, 0, 0}).value, -1);
    EXPECT_EQ(at("sign(x)", {0, 0, 0}).value, 0);
    EXPECT_EQ(at("mod(x, 3)", {-1, 0, 0}).value, 2);
}

TEST(Dual, HasOddRootsOfAllNumbers) {
    for (const int n : {3, 5, 7, 101}) {
        const Expr root = operator_on_variables(op_info(Op::OddRoot), n);
        for (const double x : {-3.0, -0.2, 0.01, 1.0, 8.0}) {
            const Dual<double> found = value_at(root, {x, 0, 0, 0});
            const double expected = std::copysign(std::pow(std::abs(x), 1.0 / n), x);
            EXPECT_NEAR(found.value, expected, 1e-15 * std::abs(expected) * 4) << n << " of " << x;
            EXPECT_NEAR(*found.slope[0], expected / (n * x), 1e-13 * expected / (n * x));
        }
        EXPECT_EQ(value_at(root, {0, 0, 0, 0}).value, 0);
        EXPECT_EQ(value_at(root, {-infinity, 0, 0, 0}).value, -infinity);
    }
}

TEST(Dual, IsNoNumberWhereNothingIsDefined) {
    const Expr restricted = operator_on_variables(op_info(Op::Where));  // x where z <= x
    EXPECT_EQ(value_at(restricted, {2, 0, 1, 0}).value, 2);
    EXPECT_TRUE(std::isnan(value_at(restricted, {1, 0, 2, 0}).value));
    EXPECT_TRUE(std::isnan(at("if(sqrt(x) > 0, 1, 2)", {-1, 0, 0}).value));
    EXPECT_EQ(at("if(x > 0, ln(x), -1)", {-1, 0, 0}).value, -1);
}

class DualOperator : public ::testing::TestWithParam<OpInfo> {};

/// Compares slopes with central differences where both steps stay on one smooth piece.
TEST_P(DualOperator, AgreesWithCentralDifferences) {
    const Expr expr = operator_on_variables(GetParam(), 5);
    RandomNumbers random(40);
    constexpr double step = 1e-6;
    int compared = 0;
    for (int i = 0; i < 500; ++i) {
        const double shift = GetParam().op == Op::Acosh ? 1 : 0;  // into its domain
        const std::array<double, 4> p{shift + random.uniform(0.1, 0.8), random.uniform(0.1, 0.8), 0,
                                      0};
        if (std::abs(p[0] - p[1]) < 4 * step) continue;  // the kink of min and max, a condition
        if (GetParam().op == Op::Round && std::abs(p[0] - 0.5) < 4 * step) continue;
        const double quotient = p[0] / p[1];
        const bool near_step = std::abs(quotient - std::nearbyint(quotient)) < 1e-4;
        if (GetParam().op == Op::Mod && near_step) continue;
        const Dual<double> here = value_at(expr, p);
        for (std::size_t k = 0; k < 2; ++k) {
            auto before = p;
            auto after = p;
            before.at(k) -= step;
            after.at(k) += step;
            const double difference =
                (value_at(expr, after).value - value_at(expr, before).value) / (2 * step);
            const double slope = here.slope[k].value_or(0.0);
            ASSERT_NEAR(slope, difference, 1e-6 * (1 + std::abs(slope)))
                << "at " << p[0] << ", " << p[1];
            ++compared;
        }
    }
    EXPECT_GT(compared, 900);
}

INSTANTIATE_TEST_SUITE_P(All, DualOperator, ::testing::ValuesIn(operators()),
                         [](const auto& row) { return op_name(row); });

}  // namespace
}  // namespace zeroset::test::dual_test
