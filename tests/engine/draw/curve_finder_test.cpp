#include "engine/draw/curve_finder.hpp"

#include "engine/draw/curve_system.hpp"
#include "engine/draw/symmetric.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace zeroset::test::curve_finder_test {
namespace {

struct Finding {
    Uniforms uniforms;
    CurveSystem system;
    Page page;
    CurveDomain domain;

    Finding(const std::vector<std::string>& texts, const Box& box)
        : uniforms(no_uniforms()),
          system(equations_of(texts, uniforms, box)),
          page(default_camera(box), {}),
          domain{.box = box, .page = page} {}
    Finding(const Finding&) = delete;
    Finding& operator=(const Finding&) = delete;

    [[nodiscard]] FoundCurves curves() const { return find_curves(system, domain, {}); }

private:
    static Uniforms no_uniforms() {
        Uniforms uniforms;
        uniforms.set(0, 0.0);
        return uniforms;
    }
    static CurveEquations equations_of(const std::vector<std::string>& texts,
                                       const Uniforms& uniforms, const Box& box) {
        CurveEquations equations;
        for (const std::string& text : texts)
            equations.zero.push_back(std::make_shared<const SpaceFunction>(
                parse(text).value(), uniforms, box, [](const Expr& f) { return interpret(f); }));
        return equations;
    }
};

/// A polynomial in x, y and z with small random coefficients.
std::string random_polynomial(RandomNumbers& random) {
    std::string text = std::to_string(random.uniform(-1, 1));
    for (const char* term : {"x", "y", "z", "x^2", "y^2", "z^2", "x*y", "y*z", "x*z", "x^3",
                             "y*z^2", "x^2*y^2", "z^4"})
        text += " + (" + std::to_string(random.uniform(-1, 1)) + ")*" + term;
    return text;
}

TEST(CurveFinder, FindsALoopOnceAndClosesIt) {
    const Finding of({"x^2 + y^2 + z^2 - 1", "z - 0.3*x"}, Box::cube(2));
    const FoundCurves found = of.curves();
    ASSERT_EQ(found.curves.size(), 1U);
    EXPECT_TRUE(found.curves[0].closed);
    EXPECT_EQ(found.report.open, 0U);
    EXPECT_EQ(found.report.stuck, 0U);
}

TEST(CurveFinder, FindsSmallLoopsBesideLargeOnes) {
    // Circles of radius 1 and 0.01 in the plane z = 0.
    const Finding of({"(x^2 + y^2 - 1)*((x - 0.3)^2 + (y - 0.2)^2 - 0.0001)", "z"}, Box::cube(2));
    const FoundCurves found = of.curves();
    ASSERT_EQ(found.curves.size(), 2U);
    EXPECT_TRUE(found.curves[0].closed && found.curves[1].closed);
    EXPECT_EQ(found.report.open, 0U);
}

TEST(CurveFinder, TellsCloseCurvesApart) {
    const Finding of({"(x^2 + y^2 - 1)*(x^2 + y^2 - 0.99)", "z"}, Box::cube(2));
    const FoundCurves found = of.curves();
    EXPECT_EQ(found.curves.size(), 2U);
    EXPECT_EQ(found.report.open, 0U);
}

TEST(CurveFinder, CurvesThatCrossAreFollowedThroughTheCrossing) {
    const Finding of({"(y - 0.3*x)*(y + 0.2*x)", "z - 0.1*x*y"}, Box::cube(1));
    const FoundCurves found = of.curves();
    EXPECT_EQ(found.curves.size(), 2U);
    EXPECT_GT(found.report.open, 0U);
    EXPECT_LE(found.report.open_pt, SearchLimits().smallest_pt);
}

TEST(CurveFinder, CurvesEndAtTheFacesOfTheBox) {
    const Finding of({"x - 0.2*y", "z - 0.3*y"}, Box::cube(1));
    const FoundCurves found = of.curves();
    ASSERT_EQ(found.curves.size(), 1U);
    for (const CurvePoint* end : {&found.curves[0].points.front(), &found.curves[0].points.back()})
        EXPECT_NEAR(std::abs(end->place.y), 1.0, 1e-9);
}

TEST(CurveFinder, FindsNothingWhereThereIsNothing) {
    const Finding of({"x^2 + y^2 + z^2 - 1", "z - 1.01"}, Box::cube(2));
    const FoundCurves found = of.curves();
    EXPECT_TRUE(found.curves.empty());
    EXPECT_EQ(found.report.open, 0U);
}

TEST(CurveFinder, PointsSatisfyTheEquationsOnRandomSurfaces) {
    RandomNumbers random(7);
    std::size_t curves = 0;
    for (int i = 0; i < 20; ++i) {
        const Finding of({random_polynomial(random), random_polynomial(random)}, Box::cube(1.5));
        const FoundCurves found = of.curves();
        curves += found.curves.size();
        EXPECT_EQ(found.report.stuck, 0U);
        for (const SpaceCurve& curve : found.curves) {
            for (const CurvePoint& point : curve.points) {
                const Linearized there = of.system.at(point.place);
                EXPECT_LT(glm::length(there.step(there.across)), 1e-10);
                EXPECT_GT(std::abs(glm::dot(there.tangent(), point.tangent)), 1.0 - 1e-9);
            }
        }
    }
    EXPECT_GT(curves, 15U);
}

/// Whether a curve passes within `reach` of the point.
bool passes(const std::vector<SpaceCurve>& curves, const glm::dvec3& point, double reach) {
    return std::ranges::any_of(curves, [&](const SpaceCurve& curve) {
        const std::size_t count = curve.points.size();
        for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i) {
            const CurvePoint& a = curve.points[i];
            const CurvePoint& b = curve.points[(i + 1) % count];
            for (int part = 0; part <= 16; ++part) {
                const double near = glm::distance(between(a, b, part / 16.0), point);
                if (near < reach + glm::distance(a.place, b.place) / 32.0) return true;
            }
        }
        return false;
    });
}

TEST(CurveFinder, MissesNothingThatNewtonsMethodFindsFromRandomPoints) {
    RandomNumbers random(11);
    int tried = 0;
    for (int i = 0; i < 20; ++i) {
        const Finding of({random_polynomial(random), random_polynomial(random)}, Box::cube(1.5));
        const FoundCurves found = of.curves();
        EXPECT_EQ(found.report.open, 0U);
        for (int k = 0; k < 300; ++k) {
            const glm::dvec3 start(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5),
                                   random.uniform(-1.5, 1.5));
            const auto point = of.system.point_near(start, 3.0);
            if (!point || !of.domain.contains(*point)) continue;
            ++tried;
            EXPECT_TRUE(passes(found.curves, *point, 1e-4)) << i << " " << k;
        }
    }
    EXPECT_GT(tried, 1000);
}

TEST(CurveSystem, EmptyCellsHoldNoPoint) {
    RandomNumbers random(13);
    int empty = 0;
    for (int i = 0; i < 10; ++i) {
        const Finding of({random_polynomial(random), random_polynomial(random)}, Box::cube(1.5));
        for (int k = 0; k < 300; ++k) {
            const glm::dvec3 middle(random.uniform(-1, 1), random.uniform(-1, 1),
                                    random.uniform(-1, 1));
            const glm::dvec3 half(random.uniform(0.001, 0.3));
            const std::vector<CurveCell> cells{
                {.place = {}, .box = {.lo = middle - half, .hi = middle + half}}};
            if (judge_cells(of.system, cells)[0].state != CellState::Empty) continue;
            ++empty;
            const auto point = of.system.point_near(middle, 1.0);
            if (!point) continue;
            const glm::dvec3 off = glm::abs(*point - middle);
            EXPECT_GT(std::max({off.x, off.y, off.z}), half.x * (1.0 - 1e-9));
        }
    }
    EXPECT_GT(empty, 1000);
}

TEST(Symmetric, EigenvectorsMakeTheMatrixAgain) {
    RandomNumbers random(17);
    for (int i = 0; i < 100; ++i) {
        glm::dmat3 matrix(0.0);
        for (int row = 0; row < 3; ++row) {
            for (int col = 0; col <= row; ++col)
                matrix[col][row] = matrix[row][col] = random.uniform(-1, 1);
        }
        const Eigenvectors all = eigenvectors_of(matrix);
        EXPECT_GE(all.values[0], all.values[1]);
        EXPECT_GE(all.values[1], all.values[2]);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 off = matrix * all.vectors[k] - all.values[k] * all.vectors[k];
            EXPECT_LT(glm::length(off), 1e-12);
            EXPECT_NEAR(glm::length(all.vectors[k]), 1.0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace zeroset::test::curve_finder_test
