// Tests of the special points of a surface that Newton's method finds near a place.

#include "pipeline/probe_document.hpp"
#include "tests/support/formulas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

namespace zeroset::test::snap_point_test {
namespace {

std::optional<SpecialPoint> near(const std::string& text, const glm::dvec3& from,
                                 const Region& region = {}, const glm::dvec3& up = {0, 0, 1},
                                 double half = 2.0) {
    const auto program = read_formula(text);
    EXPECT_TRUE(program) << text;
    Uniforms uniforms;
    uniforms.set(0, 0.0);
    for (std::size_t i = 0; i < program->parameters.size(); ++i)
        uniforms.set(1 + i, 1.0);
    return nearest_special_point(
        derived_formula(program->surfaces[0]), uniforms,
        {.from = from, .up = up, .clip = Box::cube(half), .region = region});
}

void expect_point(const std::optional<SpecialPoint>& found, SpecialKind kind, const glm::dvec3& at,
                  double tolerance) {
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, kind);
    EXPECT_LE(glm::distance(found->at, at), tolerance)
        << found->at.x << " " << found->at.y << " " << found->at.z;
}

TEST(SpecialPoint, IsTheTipOfACone) {
    expect_point(near("x^2 + y^2 = z^2", {0.3, 0.2, 0.36}), SpecialKind::Singular, {0, 0, 0}, 1e-9);
    expect_point(near("(x - 0.3)^2 + (y + 0.2)^2 = 4 (z - 0.1)^2", {0.4, -0.2, 0.15}),
                 SpecialKind::Singular, {0.3, -0.2, 0.1}, 1e-9);
}

TEST(SpecialPoint, IsADegenerateSingularityToFewerDigits) {
    expect_point(near("x^2 + y^2 = z^3", {0.1, 0.05, 0.23}), SpecialKind::Singular, {0, 0, 0},
                 1e-6);
    expect_point(near("x^2 + y^3 + z^4 = 0", {0.1, -0.2, 0.1}), SpecialKind::Singular, {0, 0, 0},
                 1e-4);
}

TEST(SpecialPoint, IsTheNearestOfACurveOfSingularPoints) {
    // Whitney's umbrella meets itself along the axis z.
    const auto found = near("x^2 = y^2 z", {0.02, 0.03, 0.5});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, SpecialKind::Singular);
    EXPECT_LE(std::hypot(found->at.x, found->at.y), 1e-7);
    EXPECT_NEAR(found->at.z, 0.5, 0.3) << "of the curve's points one nearby";
}

TEST(SpecialPoint, IsATopOrABottom) {
    expect_point(near("x^2 + y^2 + z^2 = 1", {0.3, 0.1, 0.9}), SpecialKind::Top, {0, 0, 1}, 1e-9);
    expect_point(near("x^2 + y^2 + z^2 = a", {0.3, 0.1, -0.9}), SpecialKind::Bottom, {0, 0, -1},
                 1e-9);
    expect_point(near("1 = x^2 + y^2 + z^2", {0.3, 0.1, 0.9}), SpecialKind::Top, {0, 0, 1}, 1e-9);
    expect_point(near("x^2 + y^2 + z^2 = 1", {-0.9, 0.1, 0.1}, {}, {1, 0, 0}), SpecialKind::Bottom,
                 {-1, 0, 0}, 1e-9);
    expect_point(near("z = cos(3 x) cos(3 y)", {0.1, 0.1, 0.9}), SpecialKind::Top, {0, 0, 1}, 1e-9);
}

TEST(SpecialPoint, IsTheNearestOfATorussUppermostCircle) {
    const auto found = near("(x^2 + y^2 + z^2 + 0.84)^2 = 4 (x^2 + y^2)", {0.7, 0.7, 0.4});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, SpecialKind::Top);
    EXPECT_NEAR(std::hypot(found->at.x, found->at.y), 1.0, 1e-7);
    EXPECT_NEAR(found->at.z, 0.4, 1e-7);
    EXPECT_NEAR(found->at.x, found->at.y, 0.1);
}

TEST(SpecialPoint, IsNoneWhereThereIsNone) {
    EXPECT_FALSE(near("z = 0.5", {0.1, 0.2, 0.5})) << "flat";
    EXPECT_FALSE(near("z = x y", {0.1, 0.1, 0.01})) << "a saddle is neither";
    EXPECT_FALSE(near("x^2 + y^2 = 1", {1, 0, 0})) << "a cylinder that stands";
    EXPECT_FALSE(near("x^2 + y^2 + z^2 = 0.5 + 0 x", {0.1, 0.2, 0.5},
                      {.ball = Ball{{1, 1, 1}, 0.3}, .sections = {}}))
        << "beyond the region";
    EXPECT_FALSE(near("x^2 + y^2 + (z - 9)^2 = 1", {0, 0, 2})) << "beyond the box";
    EXPECT_FALSE(near("x^2 + y^2 + z^2 = -1", {0.1, 0.2, 0.1})) << "no surface";
    EXPECT_FALSE(near("x^2 + y^2 + z^2 = 1e-3 - 2e-3", {0.01, 0, 0}))
        << "a gradient's zero off f's";
}

TEST(SpecialPoint, IsFoundAtAnyScale) {
    for (const double size : {1e-6, 1e-3, 1e6}) {
        const std::string s = std::to_string(size * size * 1e12) + " * 1e-12";
        expect_point(near("x^2 + y^2 + z^2 = " + s, size * glm::dvec3(0.3, 0.1, 0.9), {}, {0, 0, 1},
                          2.0 * size),
                     SpecialKind::Top, {0, 0, size}, 1e-7 * size);
    }
}

TEST(SpecialPoint, IsNumericalAndSaysHowWell) {
    const auto found = near("x^2 + y^2 = z^2", {0.3, 0.2, 0.36});
    ASSERT_TRUE(found);
    EXPECT_LE(std::abs(found->f), 1e-15);
    EXPECT_LE(found->slope, 1e-7);
}

}  // namespace
}  // namespace zeroset::test::snap_point_test
