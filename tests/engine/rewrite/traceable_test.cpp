#include "engine/rewrite/traceable.hpp"

#include "engine/expr/simplify.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/rewrite/passes.hpp"
#include "engine/rewrite/polynomial/tighten.hpp"
#include "engine/rewrite/sample/form_sample.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace zeroset::traceable_test {
namespace {

std::string cleared(const char* text) { return without_poles(*parse(text)).canonical(); }
std::string as_typed(const char* text) { return parse(text)->canonical(); }

TEST(WithoutPoles, BringsQuotientsToOne) {
    EXPECT_EQ(cleared("1/(x - y^2) - z"), "(1 - z*(x - y^2))/(x - y^2)");
    EXPECT_EQ(cleared("x/y + z"), "(x + z*y)/y");
    EXPECT_EQ(cleared("(x^2+1)/(y-z) = 2"), "(x^2 + 1 - 2*(y - z))/(y - z)");
    EXPECT_EQ(cleared("-x/y + z/y"), "(-x + z)/y");
    EXPECT_EQ(cleared("(x/y)^3 - z"), "(x^3 - z*y^3)/y");
    EXPECT_EQ(cleared("tan(x) = y"), "(sin(x) - y*cos(x))/cos(x)");
    EXPECT_EQ(cleared("cot(x) = y"), "(cos(x) - y*sin(x))/sin(x)");
    EXPECT_EQ(cleared("1/x = y, z < 1"), "(1 - y*x)/x, z < 1");
    const Expr expr = without_poles(*parse("1/(x - y^2) - z"));
    EXPECT_EQ(expr.node(expr.root()).op, Op::Oriented);
}

TEST(WithoutPoles, KeepsTheDomain) {
    EXPECT_EQ(cleared("1/(x-y)^2 = z"), "1 - z*(x - y)^2, x - y < 0 or 0 < x - y");
    EXPECT_EQ(cleared("x*(y/x + 1) = z"), "y + x - z, x < 0 or 0 < x");
    EXPECT_EQ(cleared("x/(y/z) = 1"), "where(x*z - y, z < 0 or 0 < z)/y");
    EXPECT_EQ(cleared("z/x - z/x"), "(z - z)/x");
}

TEST(WithoutPoles, LeavesOtherDivisionsAlone) {
    for (const char* text : {"0.25/(x^2 + y^2 + z^2) + 0.16/(x^2 + (y - 0.7)^2 + z^2) - 1",
                             "1/(x^2 + y^2) - z", "x/2 + y", "x/a + y", "1/(x^2 + 1) - y",
                             "z/sqrt(x^2 + y^2 + z^2) - 0.5", "sin(1/x) - y", "x^2 + y^2 - 1"}) {
        EXPECT_EQ(cleared(text), as_typed(text));
    }
    EXPECT_EQ(cleared("1/(x^2 + y^2) + 1/z"), "(1/(x^2 + y^2)*z + 1)/z");
}

TEST(WithoutPoles, LooksInTheRegionOnly) {
    const Expr expr = *parse("1/(x - 5) - y");
    EXPECT_EQ(without_poles(expr).key(), expr.key());
    const SampleRegion far{{-9, -9, -9}, {9, 9, 9}, {}};
    EXPECT_EQ(without_poles(expr, far).canonical(), "(1 - y*(x - 5))/(x - 5)");
}

TEST(WithoutPoles, GivesUpOnManyPoles) {
    std::string text = "1/x";
    for (int i = 1; i <= 7; ++i)
        text += " + 1/(y - 0." + std::to_string(i) + "*x)";
    EXPECT_EQ(cleared(text.c_str()), as_typed(text.c_str()));
}

TEST(Traceable, IsTightOnlyWhereThatSavesBeams) {
    const Expr tangle = *parse("x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8");
    EXPECT_EQ(traceable(tangle).key(), tightened(tangle).key());
    EXPECT_NE(traceable(tangle).key(), tangle.key());
    // Three times the operators for enclosures in interval arithmetic that no beam needs.
    const Expr tori = *parse(
        "((x^2 + (y - 0.2)^2 + z^2 + 0.13)^2 - 0.53*(x^2 + (y - 0.2)^2))"
        "*((z^2 + (y + 0.2)^2 + x^2 + 0.13)^2 - 0.53*(z^2 + (y + 0.2)^2)) + 0.00001");
    const SampleRegion region{{-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}, {}};
    EXPECT_NE(tightened(tori, region).key(), tori.key());
    EXPECT_EQ(traceable(tori, region).key(), tori.key());
}

TEST(FormSample, TellsWhereFormsLeaveRoom) {
    const SampleRegion region;
    const Expr nowhere = *parse("x^2 + y^2 + z^2 + 1");
    EXPECT_EQ(FormSample(nowhere, region).open(nowhere), 0.0);
    const Expr ball = *parse("x^2 + y^2 + z^2 - 1");
    const FormSample sample(ball, region);
    EXPECT_GT(sample.open(ball), 0.1);
    EXPECT_LT(sample.open(ball), 0.9);
    EXPECT_EQ(sample.open(ball), FormSample(ball, region).open(ball));
    EXPECT_EQ(sample.open(ball), sample.open());
    EXPECT_GT(sample.open(*parse("(x^2 + y^2 + z^2)^2/(x^2 + y^2 + z^2) - 1")), sample.open(ball));
    const Expr with_parameters = *parse("a*x^2 + w - z");
    EXPECT_LT(FormSample(with_parameters, region).open(with_parameters), 0.9);
}

TEST(PlainAngles, TakesThemFromLengths) {
    const auto plain = [](const char* text) { return plain_angles(*parse(text)).canonical(); };
    EXPECT_EQ(plain("acos(z/sqrt(x^2 + y^2 + z^2)) - y"), "atan2(sqrt(x^2 + y^2), z) - y");
    EXPECT_EQ(plain("asin(x/sqrt(x^2 + y^2))"), "atan2(x, abs(y))");
    for (const char* text : {"acos(z/sqrt(x^2 + y + z^2))", "acos(z/sqrt(x^2 + y^2))", "acos(x/y)",
                             "acos(2*z/sqrt(x^2 + z^2))", "asin(x)"}) {
        EXPECT_EQ(plain(text), as_typed(text));
    }
    const Expr wave = plain_angles(*parse("sin(4*acos(z/sqrt(x^2 + y^2 + z^2)))"));
    EXPECT_TRUE(
        std::ranges::any_of(wave.nodes(), [](const Node& node) { return node.op == Op::Angle; }));
}

TEST(PolarForm, TakesLengthsTogether) {
    const auto polar = [](const char* text) { return polar_form(*parse(text)).canonical(); };
    EXPECT_EQ(polar("sqrt(x^2 + y^2) - 1"), "sqrt(x^2 + y^2) - 1");
    EXPECT_EQ(polar("sqrt(x^2 + y^4 + (z - 1)^2)"), "sqrt(x^2 + (y^2)^2 + (z - 1)^2)");
    const Expr length = polar_form(*parse("sqrt((x - 1)^2 + y^2)"));
    EXPECT_EQ(length.node(length.root()).op, Op::Length);
    EXPECT_EQ(value_at(length, {4, 4, 0, 0}).value, 5.0);
    EXPECT_NEAR(*value_at(length, {4, 4, 0, 0}).slope[0], 0.6, 1e-15);
    for (const char* text : {"sqrt(x^2 + y)", "sqrt(x^2 + 1)", "sqrt(x^2 + y^3)", "sqrt(x)"})
        EXPECT_EQ(polar_form(*parse(text)).key(), parse(text)->key()) << text;
}

TEST(PolarForm, TakesWavesOfWholeMultiplesOfAngles) {
    struct Case {
        const char* text;
        Op op;
        int number;
    };
    for (const auto& [text, op, number] :
         {Case{"sin(atan2(y, x))", Op::AngleSin, 1}, Case{"sin(3*atan2(y, x))", Op::AngleSin, 3},
          Case{"cos(-(atan2(y, x)*4))", Op::AngleCos, 4},
          Case{"cos(2*(3*atan2(y, x)))", Op::AngleCos, 6}}) {
        const Expr expr = polar_form(*parse(text));
        const Node& root = expr.node(expr.root());
        EXPECT_EQ(root.op, op) << text;
        EXPECT_EQ(root.number, number) << text;
        const std::array at{-0.6, 0.35, 0.0, 0.0};
        const Dual<double> typed = value_at(*parse(text), at);
        const Dual<double> wave = value_at(expr, at);
        EXPECT_NEAR(wave.value, typed.value, 1e-14) << text;
        EXPECT_NEAR(*wave.slope[0], *typed.slope[0], 1e-13) << text;
        EXPECT_NEAR(*wave.slope[1], *typed.slope[1], 1e-13) << text;
    }
    EXPECT_EQ(polar_form(*parse("sin(-3*atan2(y, x))")).canonical(), "-sin(3*atan2(y, x))");
    EXPECT_TRUE(std::isnan(value_at(polar_form(*parse("sin(2*atan2(y, x))")), {}).value));
    for (const char* text : {"sin(0.5*atan2(y, x))", "sin(z*atan2(y, x))", "sin(x)",
                             "cos(5000*atan2(y, x))", "atan2(y, x)"}) {
        EXPECT_EQ(polar_form(*parse(text)).key(), parse(text)->key()) << text;
    }
}

/// At a root, the gradient of what is drawn is a positive multiple of the gradient of f.
TEST(Traceable, GradientsAtRootsPointTheSameWay) {
    const Expr typed = *parse("1/(x - y^2) - z");
    const Expr drawn = traceable(typed);
    for (const double x : {-1.5, -0.25, 0.5, 1.25}) {
        const double y = 0.75;
        const double divisor = x - y * y;
        const std::array at{x, y, 1 / divisor, 0.0};
        const Dual<double> f = value_at(typed, at);
        const Dual<double> g = value_at(drawn, at);
        EXPECT_NEAR(g.value, 0.0, 1e-14);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(g.slope[i].value_or(0.0), f.slope[i].value_or(0.0) * std::abs(divisor),
                        1e-13);
        }
    }
}

/// Sums, products, powers and quotients of the variables, conditions and odd functions between.
NodeId random_quotient(ExprBuilder& builder, test::RandomNumbers& random, int depth) {
    if (depth == 0) {
        if (random.one_in(4)) return builder.constant(random.between(-2, 2));
        return builder.variable(random.between(0, 2));
    }
    const auto operand = [&] { return random_quotient(builder, random, depth - 1); };
    switch (random.between(0, 9)) {
        case 0:
        case 1: return make_add(builder, operand(), operand());
        case 2: return make_subtract(builder, operand(), operand());
        case 3:
        case 4: return make_multiply(builder, operand(), operand());
        case 5: return make_int_power(builder, operand(), random.between(1, 3));
        case 6: return make_negate(builder, operand());
        case 7: return make_call(builder, random.one_in(2) ? Op::Tan : Op::Sqrt, operand());
        default: return make_divide(builder, operand(), operand());
    }
}

/// Whether the reference agrees in domain and sign at some points, poles and zeros among them.
void expect_same_signs(const Expr& typed, const Expr& drawn, test::RandomNumbers& random) {
    for (int i = 0; i < 20; ++i) {
        const bool on_grid = i % 2 == 0;
        std::array<double, 4> at{};
        for (double& x : at)
            x = on_grid ? 0.5 * random.between(-3, 3) : random.uniform(-2, 2);
        const test::Reference f = test::reference(typed, at);
        const test::Reference g = test::reference(drawn, at);
        if (f.defined && f.is_unknown()) continue;
        ASSERT_EQ(f.defined, g.defined) << typed.canonical() << "\n" << drawn.canonical();
        if (!f.defined || g.is_unknown() || !f.value.is_finite()) continue;
        const double size = std::abs(f.value.nearest());
        const double least = 1e-60;  // the reference has 256 bits
        if (size > 0 && size < least) continue;
        const double drawn_size = std::abs(g.value.nearest());
        if (size == 0) {
            EXPECT_LT(drawn_size, least) << typed.canonical() << "\n" << drawn.canonical();
        } else {
            EXPECT_EQ(f.value.sign(), g.value.sign()) << typed.canonical() << "\n"
                                                      << drawn.canonical();
        }
    }
}

TEST(Traceable, KeepsRandomQuotientsZerosDomainsAndSigns) {
    test::RandomNumbers random(11);
    int rewritten = 0;
    for (int formula = 0; formula < 600; ++formula) {
        ExprBuilder builder;
        const Expr typed = builder.finish(random_quotient(builder, random, 2 + formula % 4));
        const Expr drawn = without_poles(typed);
        if (drawn.key() == typed.key()) continue;
        ++rewritten;
        expect_same_signs(typed, drawn, random);
        if (formula % 6 == 0) expect_same_signs(typed, traceable(typed), random);
    }
    EXPECT_GT(rewritten, 150);
}

TEST(Traceable, KeepsRandomGraphsZerosDomainsAndSigns) {
    test::RandomNumbers random(12);
    for (int formula = 0; formula < 400; ++formula) {
        const Expr typed = test::random_expression(random, 1 + formula % 5);
        const Expr drawn = without_poles(plain_angles(typed));
        if (drawn.key() != typed.key()) expect_same_signs(typed, drawn, random);
    }
}

}  // namespace
}  // namespace zeroset::traceable_test
