#include "engine/language/parse.hpp"
#include "engine/view/camera.hpp"
#include "tests/support/oracle/polynomial_oracle.hpp"
#include "tests/support/oracle/random_surface.hpp"
#include "tests/support/oracle/subdivision_oracle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Checks of the ray oracles on rays whose roots are known, and against each other.

namespace zeroset::test::ray_oracles_test {
namespace {

constexpr std::array no_w{0.0};

Expr parsed(const std::string& text) {
    const auto expr = parse(text);
    if (expr) return *expr;
    ADD_FAILURE() << text << ": " << expr.error().reason;
    return parse("x").value();
}

/// The ray along x with y = z = 0 and x = t - 2, in the cube of half edge 2.
RayQuestion along_x() { return {{-2, 0, 0}, {1, 0, 0}, 0, 4, -1e-6, 4 + 1e-6}; }

std::vector<RayRoot> roots_of(const std::string& text) {
    const auto oracle = PolynomialOracle::of(parsed(text), no_w);
    if (!oracle) {
        ADD_FAILURE() << text << " is no polynomial";
        return {};
    }
    return oracle->roots(along_x()).value_or(std::vector<RayRoot>{});
}

RayAnswer answer_of(const std::string& text) {
    return SubdivisionOracle(parsed(text), no_w).answer(along_x());
}

TEST(PolynomialOracle, FindsAllRootsInOrder) {
    const auto roots = roots_of("(x - 1/3)*(x + 0.7)^2*(x - 0.333)^3*(x^2 + 1)*(x - 5)*(x + y)");
    const std::vector<double> places{-0.7, 0.0, 0.333, 1.0 / 3};
    const std::vector<bool> crossings{false, true, true, true};
    ASSERT_EQ(roots.size(), places.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
        EXPECT_LE(roots[i].from, places[i] + 2);
        EXPECT_GE(roots[i].to, places[i] + 2);
        EXPECT_LT(roots[i].to - roots[i].from, 1e-8);
        EXPECT_EQ(roots[i].crosses, crossings[i]) << i;
    }
}

TEST(PolynomialOracle, IsolatesTwentyRootsInARow) {
    std::string text = "1";
    for (int i = 1; i <= 20; ++i)
        text += "*(x - " + std::to_string(i) + "/40)";
    const auto roots = roots_of(text);
    ASSERT_EQ(roots.size(), 20U);
    for (std::size_t i = 0; i < 20; ++i)
        EXPECT_NEAR(roots[i].from, 2 + static_cast<double>(i + 1) / 40, 1e-8);
    EXPECT_EQ(PolynomialOracle::of(parsed(text), no_w)->roots(along_x(), 3)->size(), 3U);
}

TEST(PolynomialOracle, TakesDecimalsAsTheyAreWritten) {
    // With the doubles nearest to 0.1 and 0.01, the square of the first is not the second.
    const auto roots = roots_of("(x - 0.1)^2 - x^2 + 0.2*x - 0.01 + x^3");
    ASSERT_EQ(roots.size(), 1U);
    EXPECT_NEAR(roots[0].from, 2, 1e-8);
    EXPECT_TRUE(roots_of("(x - 0.1)^2 - x^2 + 0.2*x - 0.01").empty());  // 0 everywhere
}

TEST(PolynomialOracle, RefusesWhatIsNoPolynomial) {
    for (const char* text : {"sin(x)", "1/x", "pi*x", "abs(x)", "sqrt(2)*x", "x^0.5"})
        EXPECT_FALSE(PolynomialOracle::of(parsed(text), no_w)) << text;
    EXPECT_TRUE(PolynomialOracle::of(parsed("x/3 - w"), no_w));
}

TEST(SubdivisionOracle, FindsTheFirstRootWhereFIsContinuous) {
    const std::vector<std::pair<std::string, double>> cases{{"sin(x)*(x - 1)", 0.0},
                                                            {"exp(x) - 2", std::log(2.0)},
                                                            {"abs(x) - 0.5", -0.5},
                                                            {"max(x - 0.25, -1 - x)", -1.0},
                                                            {"(x - 0.3)^3", 0.3},
                                                            {"sqrt(x + 1) - 0.5", -0.75},
                                                            {"1/(x - 0.7) + 1/(x + 0.7)", 0.0},
                                                            {"if(x < 0.1, 1, x - 0.6)", 0.6},
                                                            {"floor(x) - 0.5 + x", 0.5}};
    for (const auto& [text, place] : cases) {
        const RayAnswer answer = answer_of(text);
        const bool known = answer.truth == RayTruth::Hit;
        // Beyond a pole or a jump nothing is known.
        const bool behind = text.find('/') != std::string::npos || text.starts_with("if") ||
                            text.starts_with("floor");
        EXPECT_TRUE(known || behind) << text;
        if (!known) continue;
        EXPECT_TRUE(answer.crosses);
        EXPECT_LE(answer.from, place + 2 + 1e-15) << text;
        EXPECT_GE(answer.to, place + 2 - 1e-15) << text;
        EXPECT_LT(answer.to - answer.from, 1e-6) << text;
    }
}

TEST(SubdivisionOracle, SeesWhereThereIsNothing) {
    for (const char* text : {"x^2 + 0.01", "exp(x)", "sqrt(x - 3)", "cosh(x) - 0.999",
                             "abs(x) + 1e-4", "min(x + 2.1, 5)", "ln(-3 - x)", "where(x, x > 1)"}) {
        EXPECT_EQ(answer_of(text).truth, RayTruth::Empty) << text;
    }
}

TEST(SubdivisionOracle, NeverTakesAJumpOrATouchForACrossing) {
    for (const char* text :
         {"1/x", "floor(x) + 0.5", "sign(x - 0.2)", "tan(x)^-1 * 0 + 1/(x - 0.1)", "x^2", "abs(x)",
          "atan2(x, -1)", "mod(x, 0.5) - 0.6 + 0.6*sign(x)"}) {
        EXPECT_NE(answer_of(text).truth, RayTruth::Hit) << text;
    }
}

TEST(SubdivisionOracle, AgreesWithExactRoots) {
    RandomNumbers random(5);
    int compared = 0;
    for (int i = 0; i < 150; ++i) {
        const std::string text =
            random_surface(surface_families()[static_cast<std::size_t>(i % 2)], 2, random);
        const Expr expr = parsed(text);
        const auto exact = PolynomialOracle::of(expr, no_w);
        ASSERT_TRUE(exact) << text;
        const Camera camera = suite_camera(2);
        const ViewFrame view(camera);
        const auto ray = ray_question(view, Box::cube(2), {}, random.between(8, 24),
                                      random.between(8, 24), 32, 32);
        if (!ray) continue;
        const RayAnswer found = SubdivisionOracle(expr, no_w).answer(*ray);
        const RayAnswer truth = exact->answer(*ray);
        if (found.truth == RayTruth::Unknown || truth.truth == RayTruth::Unknown) continue;
        ++compared;
        ASSERT_EQ(found.truth, truth.truth) << text;
        EXPECT_LE(found.from, truth.to) << text;
        EXPECT_GE(found.to, truth.from) << text;
    }
    EXPECT_GT(compared, 120);
}

TEST(RandomSurface, IsTheSameForTheSameSeed) {
    for (const SurfaceFamily& family : surface_families()) {
        RandomNumbers first(3);
        RandomNumbers second(3);
        const std::string text = random_surface(family, 1.5, first);
        EXPECT_EQ(text, random_surface(family, 1.5, second));
        EXPECT_NE(text, random_surface(family, 1.5, second));
        EXPECT_TRUE(parse(text)) << text;
    }
}

}  // namespace
}  // namespace zeroset::test::ray_oracles_test
