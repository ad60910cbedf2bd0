#include "engine/rewrite/polynomial/polynomial.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/polynomial/polynomial_form.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace zeroset::polynomial_test {
namespace {

/// The whole formula, expanded.
std::optional<Polynomial> expanded(const char* text) {
    const auto expr = parse(text);
    const auto facts = facts_of(*expr);
    const UpwardRounding upward;
    return expand(*expr, facts).of[expr->root()];
}

bool expand_to_the_same(const char* a, const char* b) {
    const auto p = expanded(a);
    const auto q = expanded(b);
    const UpwardRounding upward;
    return p && q && (*p - *q).is_zero();
}

std::string written(const char* text, PolynomialForm::Style style, bool split) {
    const auto expr = parse(text);
    const auto facts = facts_of(*expr);
    const UpwardRounding upward;
    const Expansion expansion = expand(*expr, facts);
    ExprBuilder builder;
    std::vector<NodeId> atoms;
    std::vector<int> order;
    for (const NodeId atom : expansion.atoms) {
        order.push_back(static_cast<int>(atoms.size()));
        atoms.push_back(builder.variable(expr->node(atom).number));
    }
    return builder
        .finish(
            write_polynomial(builder, atoms, *expansion.of[expr->root()], {style, split, order}))
        .canonical();
}

TEST(Polynomial, IsTheSameHoweverItIsTyped) {
    EXPECT_TRUE(expand_to_the_same("(x + y)^2", "x*x + 2*x*y + y^2"));
    EXPECT_TRUE(expand_to_the_same("(x - 1)*(x + 1)", "x^2 - 1"));
    EXPECT_TRUE(expand_to_the_same("-(x - y)/4", "y*0.25 + x*-0.25"));
    EXPECT_TRUE(expand_to_the_same("(sqrt(x) + 1)^2", "sqrt(x)^2 + 2*sqrt(x) + 1"));
}

TEST(Polynomial, DropsWhatCancelsExactly) {
    const auto p = expanded("(x + 3)^2 - 6*x - x^2");
    ASSERT_TRUE(p);
    EXPECT_TRUE(p->is_constant());
    EXPECT_EQ(p->at_zero().hi, 9.0);
    EXPECT_EQ(p->at_zero().neg_lo, -9.0);
}

TEST(Polynomial, TellsWhereSignsOfCoefficientsAreUnknown) {
    const auto on_the_way = expanded("0.1*x*3 - 0.3*x");
    ASSERT_TRUE(on_the_way);
    EXPECT_FALSE(on_the_way->is_certain());
    const auto in_the_end = expanded("0.1*x*3 - 0.3*x + x");
    ASSERT_TRUE(in_the_end);
    EXPECT_TRUE(in_the_end->is_certain());
    EXPECT_FALSE(expanded("1e300*1e300*x"));
}

TEST(Polynomial, IsNotExpandedWhereThatIsHopeless) {
    EXPECT_FALSE(expanded("(x + y + z + 1)^30"));
    EXPECT_FALSE(expanded("x^41"));
    EXPECT_FALSE(expanded("(x^2)^16777216"));
    EXPECT_TRUE(expanded("x^40"));
}

TEST(Polynomial, HasEnclosuresOfItsCoefficients) {
    const auto p = expanded("0.1*x/3");
    ASSERT_TRUE(p);
    const Interval<double> c = p->terms().front().coefficient;
    EXPECT_LT(-c.neg_lo, c.hi);
    EXPECT_LE(-c.neg_lo, 0.1 / 3);
    EXPECT_GE(c.hi, 0.1 / 3);
    EXPECT_LT(c.hi + c.neg_lo, 1e-16);
}

TEST(Polynomial, CompletesSquares) {
    const auto p = expanded("2*x^4 + 4*x^3 - x*y + 1");
    const UpwardRounding upward;
    const auto square = complete_square(*p, 0);
    ASSERT_TRUE(square);
    const Polynomial again = scaled(square->root * square->root, square->factor) + square->rest;
    EXPECT_TRUE((again - *p).is_zero());
    EXPECT_EQ(square->root.degree(0), 2);
    EXPECT_LT(square->rest.degree(0), 2);
    EXPECT_FALSE(complete_square(*p, 1));
}

TEST(Polynomial, HasNoSquareWithoutANumberBeforeIt) {
    const UpwardRounding upward;
    EXPECT_FALSE(complete_square(*expanded("y*x^2 + x"), 0));
    EXPECT_FALSE(complete_square(*expanded("x^3 + x^2"), 0));
}

TEST(PolynomialForm, OfHornerPullsOutPowers) {
    using enum PolynomialForm::Style;
    EXPECT_EQ(written("x^4 - 5*x^2", Horner, false), "x^2*(x^2 - 5)");
    EXPECT_EQ(written("x^7 + 2*x^3 + 1", Horner, false), "x^3*(x^4 + 2) + 1");
    EXPECT_EQ(written("x*y + x + y", Horner, false), "x*(y + 1) + y");
}

TEST(PolynomialForm, OfSquaresNests) {
    using enum PolynomialForm::Style;
    EXPECT_EQ(written("x^4 - 5*x^2", Squares, false), "(x^2 - 2.5)^2 - 6.25");
    EXPECT_EQ(written("8*x^8 - 16*x^6 + 10*x^4 - 2*x^2", Squares, false),
              "8*((x^2 - 0.5)^2 - 0.125)^2 - 0.125");
    EXPECT_EQ(written("x^2 + 3*x + y^2 - y", Squares, true),
              "(x + 1.5)^2 - 2.25 + ((y - 0.5)^2 - 0.25)");
}

TEST(PolynomialForm, OfTermsIsTheExpandedSum) {
    EXPECT_EQ(written("(x + 2)*(x - y)", PolynomialForm::Style::Terms, false),
              "-(x*y) - 2*y + x^2 + 2*x");
}

}  // namespace
}  // namespace zeroset::polynomial_test
