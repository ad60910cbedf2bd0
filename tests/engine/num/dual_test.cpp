#include "engine/num/dual.hpp"

#include "engine/expr/interpret.hpp"
#include "engine/expr/parse.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace zeroset::test {
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
        const double slope = found.slope.at(i).value_or(0.0);
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
    expect_gradient("log(z)", p, {0, 0, 1 / z});
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

class DualOperator : public ::testing::TestWithParam<OpInfo> {};

/// Central differences of the value, where both steps stay on one smooth piece.
TEST_P(DualOperator, AgreesWithCentralDifferences) {
    const Expr expr = operator_on_variables(GetParam(), 5);
    RandomNumbers random(40);
    constexpr double step = 1e-6;
    int compared = 0;
    for (int i = 0; i < 500; ++i) {
        const std::array<double, 4> p{random.uniform(0.1, 0.8), random.uniform(0.1, 0.8), 0, 0};
        if (std::abs(p[0] - p[1]) < 4 * step) continue;  // the kink of min and max
        const Dual<double> here = value_at(expr, p);
        for (std::size_t k = 0; k < 2; ++k) {
            auto before = p;
            auto after = p;
            before.at(k) -= step;
            after.at(k) += step;
            const double difference =
                (value_at(expr, after).value - value_at(expr, before).value) / (2 * step);
            const double slope = here.slope.at(k).value_or(0.0);
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
}  // namespace zeroset::test
