#include "engine/draw/smooth_pieces.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace zeroset::test::smooth_pieces_test {
namespace {

double value(const Expr& f, const std::array<double, 4>& at) { return value_at(f, at).value; }

TEST(SmoothPieces, OneOfThemIsTheFunction) {
    RandomNumbers random(3);
    for (const char* text :
         {"max(max(x, y), z) - 1", "min(x^2 + y^2 + z^2 - 1, max(abs(x), y) - 0.5)",
          "abs(x) + abs(y) + abs(z) - 1", "x^2 - min(y, z)*abs(x)", "x + y + z"}) {
        const Expr f = parse(text).value();
        const std::vector<Expr> pieces = smooth_pieces(f);
        for (int i = 0; i < 100; ++i) {
            const std::array<double, 4> at{random.uniform(-2, 2), random.uniform(-2, 2),
                                           random.uniform(-2, 2), 0.0};
            const double wanted = value(f, at);
            EXPECT_TRUE(std::ranges::any_of(pieces, [&](const Expr& piece) {
                return value(piece, at) == wanted;
            })) << text;
        }
    }
}

TEST(SmoothPieces, AreAsManyAsThereAreOperands) {
    EXPECT_EQ(smooth_pieces(parse("max(max(x, y), z)").value()).size(), 3U);
    EXPECT_EQ(smooth_pieces(parse("abs(x) + abs(y) + abs(z) - 1").value()).size(), 8U);
    EXPECT_EQ(smooth_pieces(parse("x^2 + y").value()).size(), 1U);
}

TEST(SmoothPieces, TooManyAreNone) {
    std::string text = "z";
    for (int i = 0; i < 9; ++i)
        text += " + abs(x - " + std::to_string(i) + " y)";
    EXPECT_EQ(smooth_pieces(parse(text).value()).size(), 1U);
}

TEST(Kinks, AreWhereTheSidesAreEqual) {
    const std::vector<CreaseBorder> kinks = kinks_of(parse("max(x + y, z) - abs(x)").value());
    ASSERT_EQ(kinks.size(), 2U);
    const std::array<double, 4> at{0.25, 0.5, 0.75, 0.0};
    int zeros = 0;
    for (const CreaseBorder& kink : kinks)
        zeros += value(kink.border, at) == 0.0 ? 1 : 0;
    EXPECT_EQ(zeros, 1);
}

TEST(RestrictionBorders, AreTheDifferencesOfComparedSides) {
    const Expr f = parse("x^2 + y^2 = 1, -0.5 < z < 0.75").value();
    std::vector<double> at_upper;
    for (const Expr& border : restriction_borders(f))
        at_upper.push_back(std::abs(value(border, {0, 0, 0.75, 0})));
    ASSERT_EQ(at_upper.size(), 2U);
    EXPECT_EQ(std::ranges::min(at_upper), 0.0);
    EXPECT_EQ(std::ranges::max(at_upper), 1.25);
}

}  // namespace
}  // namespace zeroset::test::smooth_pieces_test
