#include "engine/rewrite/polynomial/tighten.hpp"

#include "engine/expr/number.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/inclusion.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <string>

namespace zeroset::tighten_test {
namespace {

std::string tight(const char* text, double size = 3) {
    const SampleRegion region{{-size, -size, -size}, {size, size, size}, {}};
    return tightened(*parse(text), region).canonical();
}

std::string as_typed(const char* text) { return parse(text)->canonical(); }

constexpr std::array formulas{
    "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
    "4*(x^4 + (y^2+z^2)^2) + 17*x^2*(y^2+z^2) - 20*(x^2+y^2+z^2) + 17",
    "(x^2+y^2+z^2+2*y-1)*((x^2+y^2+z^2-2*y-1)^2 - 8*z^2) + 16*x*z*(x^2+y^2+z^2-2*y-1)",
    "(1-w)*(x^2 - y^2 - z^2 - 1) + w*((1 - sqrt(x^2+y^2))^2 + z^2 - 0.25)",
    "x^2 + z^2 = 10*y^3*(1 - y)^3",
    "(x^2 + y^2 + z^2 + 2.75)^2 = 4*(2*x - 0.5)^2 + 15*y^2",
    "0.1*x*y*z - x/3 + (x + 0.7)^3*(y - sqrt(2))^2",
    "sin(x)^2 - sin(x)*cos(y) + 3*sin(x) - exp(z)",
    "1/(x^2 - 3*x + y) + sqrt(z^4 - z^2 + 0.25) - 1",
    "x^2 + y^2 + z^2 - 2*x*y*z - 1",
    "max(x^2 - x, y^2 - y) - z*(z + x*(z + x))",
};

TEST(Tightened, CompletesTheSquaresOfTheTanglecube) {
    const std::string form = tight(formulas[0]);
    for (const char* square : {"(x^2 - 2.5)^2", "(y^2 - 2.5)^2", "(z^2 - 2.5)^2"})
        EXPECT_NE(form.find(square), std::string::npos) << form;
    EXPECT_EQ(parse(form)->nodes().size(), 17);
}

TEST(Tightened, CompletesABiquadratic) {
    EXPECT_EQ(tight("x^4 - 5*x^2 - y"), "(x^2 - 2.5)^2 - 6.25 - y");
}

TEST(Tightened, CompletesSquaresOfAnySubexpression) {
    EXPECT_EQ(tight("sin(x)^2 + 2*sin(x) - y"), "(sin(x) + 1)^2 - (y + 1)");
}

TEST(Tightened, SeesSumsOfSquares) {
    EXPECT_EQ(tight("x^4 + 2*x^2*y^2 + y^4 - 4*x^2 - 4*y^2 - z"), "(x^2 + (y^2 - 2))^2 - (z + 4)");
}

TEST(Tightened, LeavesWhatIsBestAsTyped) {
    for (const char* text : {"x", "x*y", "3", "x^2 + y^2 + z^2 - 1", "x^2 - y - 1", "x*y*z",
                             "(x^2 - 1)^2 + (y^2 - 1)^2 + (z^2 - 1)^2 - 1", "x^2 - y^2*z",
                             "(x - 1)*(x + 1)*(y - z)*(y + z)", "abs(x) + abs(y) - z"})
        EXPECT_EQ(tight(text), as_typed(text));
}

TEST(Tightened, KeepsParameters) {
    // a x^4 - 5 a x^2 + b
    ExprBuilder builder;
    const NodeId x = builder.variable(0);
    const NodeId a = builder.variable(variable_w + 1);
    const NodeId b = builder.variable(variable_w + 2);
    const auto term = [&](double factor, int exponent) {
        const NodeId power = make_power(builder, x, builder.constant(exponent));
        return make_multiply(builder, builder.constant(factor), make_multiply(builder, a, power));
    };
    const Expr expr = builder.finish(
        make_add(builder, make_add(builder, term(1, 4), term(-5, 2)), b), {"a", "b"});
    const Expr other =
        tightened(expr, SampleRegion{{-2, -2, -2}, {2, 2, 2}, {{0, 0}, {1, 2}, {-1, 1}}});
    EXPECT_NE(other.key(), expr.key());
    EXPECT_TRUE(std::ranges::equal(other.parameters(), expr.parameters()));
    EXPECT_TRUE(other.uses_variable(variable_w + 1) && other.uses_variable(variable_w + 2));
}

TEST(Tightened, KeepsPartialFunctionsThatCancel) {
    EXPECT_EQ(tight("x + sqrt(y) - sqrt(y)"), as_typed("x + sqrt(y) - sqrt(y)"));
    EXPECT_EQ(tight("x - z + 0*log(y)"), as_typed("x - z + 0*log(y)"));
}

TEST(Tightened, IsTightenedAlready) {
    for (const char* text :
         {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", "x^4+y^4+z^4-x^2-y^2-z^2+0.5",
          "x^4 - 5*x^2 - y", "(x^2 + y^2 + z^2 + 2.75)^2 = 4*(2*x - 0.5)^2 + 15*y^2"}) {
        const Expr once = tightened(*parse(text));
        EXPECT_EQ(tightened(once).canonical(), once.canonical());
    }
}

TEST(Tightened, LeavesAHugeGraph) {
    std::string text = "x";
    for (int i = 0; i < 1500; ++i)
        text += "+" + std::to_string(i) + "*x^" + std::to_string(i % 30 + 2);
    const auto expr = parse(text);
    ASSERT_TRUE(expr);
    EXPECT_EQ(tightened(*expr).key(), expr->key());
}

TEST(Tightened, LeavesTheRoundingModeAsItWas) {
    (void)tightened(*parse(formulas[1]));
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(Tightened, HasTheSameValues) {
    test::RandomNumbers random(11);
    for (const char* text : formulas) {
        const auto expr = parse(text);
        ASSERT_TRUE(expr) << text;
        const Expr other = tightened(*expr);
        for (int i = 0; i < 200; ++i) {
            std::array<double, 4> at{};
            for (double& x : at)
                x = random.uniform(-2, 2);
            const test::Reference a = test::reference(*expr, at);
            const test::Reference b = test::reference(other, at);
            ASSERT_EQ(a.defined, b.defined) << text;
            if (!a.defined) continue;
            const double value = a.value.nearest();
            ASSERT_NEAR(value, b.value.nearest(), 1e-11 * (1 + std::abs(value)))
                << text << "\n"
                << other.canonical();
        }
    }
}

// Random polynomials in x, y, z, w over numbers that are no doubles, too.

NodeId random_polynomial(ExprBuilder& builder, test::RandomNumbers& random, int depth) {
    if (depth == 0 || random.one_in(6)) {
        if (random.one_in(2)) return builder.variable(random.between(0, variable_w));
        static constexpr std::array texts{"1", "2", "3", "0.1", "0.7", "2.5", "13"};
        const NumberEnclosure number = enclose_number(texts[random.below(texts.size())]);
        return builder.constant(number.lo, number.hi);
    }
    const NodeId a = random_polynomial(builder, random, depth - 1);
    const int kind = random.between(0, 7);
    if (kind == 0) return make_power(builder, a, builder.constant(random.between(2, 4)));
    const NodeId b = random_polynomial(builder, random, depth - 1);
    if (kind < 3) return make_multiply(builder, a, b);
    return kind < 6 ? make_add(builder, a, b) : make_subtract(builder, a, b);
}

Interval<float> range_of(const Kernel& kernel, const std::array<Interval<float>, 4>& box) {
    std::array<std::array<float, batch_multiple>, 3> neg_lo{};
    std::array<std::array<float, batch_multiple>, 3> hi{};
    for (std::size_t v = 0; v < 3; ++v) {
        neg_lo[v].fill(box[v].neg_lo);
        hi[v].fill(box[v].hi);
    }
    const std::array<float, 2> w{box[3].neg_lo, box[3].hi};
    std::array<float, batch_multiple> f_neg_lo{};
    std::array<float, batch_multiple> f_hi{};
    std::array<std::uint32_t, batch_multiple> continuous{};
    kernel.in_float.range({batch_multiple,
                           {neg_lo[0].data(), neg_lo[1].data(), neg_lo[2].data()},
                           {hi[0].data(), hi[1].data(), hi[2].data()},
                           w.data(),
                           f_neg_lo.data(),
                           f_hi.data(),
                           continuous.data()});
    return {f_neg_lo[0], f_hi[0]};
}

/// The kernel of the tightened form encloses the function as typed.
TEST(Tightened, EnclosesTheFunctionAsTyped) {
    test::RandomNumbers random(7);
    int rewritten = 0;
    for (int formula = 0; formula < 300; ++formula) {
        ExprBuilder builder;
        const Expr typed = builder.finish(random_polynomial(builder, random, 2 + formula % 4));
        const Expr expr = tightened(typed);
        rewritten += expr.key() != typed.key() ? 1 : 0;
        const Kernel kernel = interpret(expr);
        for (int i = 0; i < 20; ++i) {
            std::array<Interval<float>, 4> box{};
            std::array<double, 4> at{};
            for (std::size_t v = 0; v < box.size(); ++v) {
                const auto lo = static_cast<float>(random.uniform(-3, 3));
                box[v] = {-lo, lo + static_cast<float>(std::exp2(random.uniform(-24, 1)))};
                at[v] = random.point_in(box[v]);
            }
            const Interval<float> range = test::in_tested_mode(range_of, kernel, box);
            // A constant that is no double is known to the reference as the middle of its
            // enclosure only: allow for 1e-13 of it.
            const double slack = 1e-13 * static_cast<double>(std::max(range.neg_lo, range.hi));
            const test::MpfrNumber truth = test::reference(typed, at).value;
            ASSERT_FALSE(truth < -static_cast<double>(range.neg_lo) - std::abs(slack) ||
                         truth > static_cast<double>(range.hi) + std::abs(slack))
                << typed.canonical() << "\n"
                << expr.canonical() << "\n"
                << truth.text() << " not enclosed by " << test::hex(range);
        }
    }
    EXPECT_GT(rewritten, 50);
}

TEST(Tightened, KeepsRandomGraphsValuesAndDomains) {
    test::RandomNumbers random(3);
    for (int formula = 0; formula < 300; ++formula) {
        const Expr typed = test::random_expression(random, 1 + formula % 5);
        const Expr expr = tightened(typed);
        if (expr.key() == typed.key()) continue;
        for (int i = 0; i < 20; ++i) {
            std::array<double, 4> at{};
            for (double& x : at)
                x = random.uniform(-2, 2);
            const test::Reference a = test::reference(typed, at);
            const test::Reference b = test::reference(expr, at);
            ASSERT_EQ(a.defined, b.defined) << typed.canonical() << "\n" << expr.canonical();
            if (!a.defined || a.is_unknown() || !a.value.is_finite()) continue;
            const double value = a.value.nearest();
            if (!std::isfinite(value)) continue;
            ASSERT_NEAR(value, b.value.nearest(), 1e-9 * (1 + std::abs(value)))
                << typed.canonical() << "\n"
                << expr.canonical();
        }
    }
}

}  // namespace
}  // namespace zeroset::tighten_test
