#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/rewrite/polynomial/polynomial_candidates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace zeroset::test::collected_terms_test {
namespace {

Expr parsed(const std::string& text) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr) << text.substr(0, 80);
    return *expr;
}

/// Each monomial up to x^6 y^5 z^4 `times` over, each time with another factor.
std::string long_sum(int times, const std::string& more = "") {
    std::string text;
    for (int i = 0; i < times; ++i) {
        for (int x = 0; x <= 6; ++x) {
            for (int y = 0; y <= 5; ++y) {
                for (int z = 0; z <= 4; ++z) {
                    const std::string factor = std::to_string(1 + (3 * x + 5 * y + 7 * z + i) % 11);
                    text += (x + y + z + i) % 3 == 0 ? " - " : " + ";
                    text += factor + "/8 x^" + std::to_string(x) + " y^" + std::to_string(y) +
                            " z^" + std::to_string(z) + more;
                }
            }
        }
    }
    return text;
}

TEST(CollectedTerms, MakeALongPolynomialShort) {
    const Expr typed = parsed(long_sum(3));
    const Expr collected = with_collected_terms(typed, {});
    EXPECT_LT(3 * collected.nodes().size(), typed.nodes().size());
    for (const auto& at : {std::array{0.5, -0.75, 1.25, 0.0}, std::array{-1.5, 0.25, 0.5, 0.0}}) {
        const Dual<double> expected = value_at(typed, at, {});
        const Dual<double> actual = value_at(collected, at, {});
        EXPECT_NEAR(actual.value, expected.value, 1e-12 * (1.0 + std::abs(expected.value)));
    }
}

TEST(CollectedTerms, LetCoefficientsCancelOnTheWay) {
    // Nothing is left of x^9; in numbers that are rounded that is not known.
    const Expr typed = parsed("0.1x^9" + long_sum(3) + " - 0.3x^9 + 0.2x^9 + 0.7x^9");
    EXPECT_LT(3 * with_collected_terms(typed, {}).nodes().size(), typed.nodes().size());
}

TEST(CollectedTerms, LeaveTheRestAsItIs) {
    for (const std::string& text : {std::string("x^2 + y^2 + x^2 - z"), long_sum(3, " sin(x)")}) {
        const Expr typed = parsed(text);
        EXPECT_TRUE(with_collected_terms(typed, {}).key() == typed.key()) << text.substr(0, 80);
    }
}

}  // namespace
}  // namespace zeroset::test::collected_terms_test
