#include "engine/language/parse.hpp"
#include "pipeline/sample_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace zeroset::test::sample_distance_test {
namespace {

using Distance = std::function<double(const glm::dvec3&)>;

OrInputError<DistanceGrid> distances_of(const std::string& equation, const GridPlan& plan,
                                        double tolerance) {
    const auto program = read_program(equation);
    EXPECT_TRUE(program.has_value()) << program.error().reason;
    Uniforms uniforms;
    uniforms.set(0, 0);
    return sampled_distance(program->surfaces.front(), uniforms, plan, tolerance);
}

glm::dvec3 point_of(const GridPlan& plan, std::uint64_t n) {
    const Geometry geometry = geometry_of(plan);
    const auto at = world_point(geometry, {static_cast<double>(n % plan.size[0]),
                                           static_cast<double>(n / plan.size[0] % plan.size[1]),
                                           static_cast<double>(n / plan.size[0] / plan.size[1])});
    return {at[0], at[1], at[2]};
}

/// All samples are proved, and as far from a closed form as the tolerance allows.
void expect_distances(const std::string& equation, const Distance& truth, const GridPlan& plan,
                      double tolerance) {
    const auto grid = distances_of(equation, plan, tolerance);
    ASSERT_TRUE(grid.has_value()) << grid.error().reason;
    EXPECT_EQ(grid->unproved, 0U) << equation;
    const auto* const found = static_cast<const float*>(grid->samples.data.get());
    double worst = 0;
    for (std::uint64_t n = 0; n < grid->samples.count(); ++n) {
        const glm::dvec3 at = point_of(plan, n);
        worst = std::max(worst, std::abs(static_cast<double>(found[n]) - truth(at)));
    }
    EXPECT_LE(worst, tolerance * 1.001) << equation;
    EXPECT_GT(worst, 0) << equation;
}

constexpr GridPlan cube(double half, std::uint64_t size) {
    return {.box = {.lo = glm::dvec3(-half), .hi = glm::dvec3(half)}, .size = {size, size, size}};
}

TEST(SampleDistance, OfASphere) {
    const Distance sphere = [](const glm::dvec3& p) { return glm::length(p) - 1; };
    expect_distances("x^2 + y^2 + z^2 = 1", sphere, cube(2, 17), 1e-2);
    expect_distances("x^2 + y^2 + z^2 = 1", sphere, cube(1.2, 24), 1e-3);
}

/// Its surface is nearest beyond the box.
TEST(SampleDistance, OfAPlaneBesideTheBox) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, 2));
    expect_distances(
        "x + 2y + 2z = 2.5", [&](const glm::dvec3& p) { return glm::dot(normal, p) - 2.5 / 3; },
        cube(1, 12), 1e-3);
}

TEST(SampleDistance, OfATorus) {
    const Distance torus = [](const glm::dvec3& p) {
        return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.3;
    };
    expect_distances("(x^2 + y^2 + z^2 + 0.91)^2 = 4 (x^2 + y^2)", torus, cube(1.5, 20), 5e-3);
}

/// Two balls that meet in a crease: outside, the distance is the least of both; inside, the nearest
/// place may be on the crease.
TEST(SampleDistance, OfAUnion) {
    const Distance both = [](const glm::dvec3& p) {
        const double a = glm::length(p - glm::dvec3(0.5, 0, 0)) - 1;
        const double b = glm::length(p + glm::dvec3(0.5, 0, 0)) - 1;
        if (std::min(a, b) >= 0) return std::min(a, b);
        const double across = std::hypot(p.y, p.z);
        const double crease = std::hypot(p.x, across - std::sqrt(0.75));
        // The foot on a ball counts where it is outside of the other one.
        const auto foot_x = [&](double centre) {
            const double x = p.x - centre;
            return centre + x / std::hypot(x, across);
        };
        double inside = crease;
        if (foot_x(0.5) >= 0) inside = std::min(inside, std::abs(a));
        if (foot_x(-0.5) <= 0) inside = std::min(inside, std::abs(b));
        return -inside;
    };
    expect_distances("min((x - 0.5)^2 + y^2 + z^2 - 1, (x + 0.5)^2 + y^2 + z^2 - 1)", both,
                     cube(2.03, 16), 1e-2);
}

/// A corner: no gradient, and the sign of a function that is no distance at all.
TEST(SampleDistance, OfACube) {
    const Distance box = [](const glm::dvec3& p) {
        const glm::dvec3 q = glm::abs(p) - 1.0;
        return glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(0.0, std::max({q.x, q.y, q.z}));
    };
    expect_distances("exp(max(abs(x), abs(y), abs(z))) = exp(1)", box, cube(1.63, 12), 2e-2);
}

TEST(SampleDistance, OfWhatTouchesZeroIsNotProvedButAsNear) {
    const GridPlan plan = cube(1.5, 6);
    const auto grid = distances_of("(x^2 + y^2 + z^2 - 1)^2", plan, 0.1);
    ASSERT_TRUE(grid.has_value()) << grid.error().reason;
    EXPECT_EQ(grid->unproved, grid->samples.count());
    EXPECT_TRUE(std::isinf(grid->worst));
    for (std::uint64_t n = 0; n < grid->samples.count(); ++n) {
        const double found =
            static_cast<double>(static_cast<const float*>(grid->samples.data.get())[n]);
        const double truth = std::abs(glm::length(point_of(plan, n)) - 1);
        EXPECT_LE(found, truth + 1e-6);
        EXPECT_GE(found, truth - 0.1);
    }
}

TEST(SampleDistance, IsNoNumberWhereFIsNotDefined) {
    const auto grid = distances_of("sqrt(x) - 0.5", cube(1, 5), 0.01);
    ASSERT_TRUE(grid.has_value());
    const auto* const found = static_cast<const float*>(grid->samples.data.get());
    EXPECT_TRUE(std::isnan(found[0]));
    EXPECT_NEAR(found[4], 0.75, 0.01);
    EXPECT_NEAR(found[2], -0.25, 0.01);
}

TEST(SampleDistance, SaysWhatCannotBe) {
    EXPECT_EQ(distances_of("x^2 + y^2 + z^2 = 9", cube(1, 5), 0.01).error().reason,
              "the surface surely has no point in the box: type another --box");
    EXPECT_EQ(distances_of("(x + y)^2", cube(1, 5), 1e-5).error().reason,
              "the surface takes too many cells to enclose to 1e-05, as where it touches 0 without "
              "crossing it: type a larger --tolerance");
}

}  // namespace
}  // namespace zeroset::test::sample_distance_test
