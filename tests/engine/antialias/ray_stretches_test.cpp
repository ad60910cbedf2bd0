#include "engine/antialias/ray_stretches.hpp"

#include "engine/antialias/square_depths.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// f on rays beside pixels' centres, against closed forms, and where squares enter the clip box
// against one square after the other.

namespace zeroset::test::ray_stretches_test {
namespace {

constexpr Camera aslant{.eye = {3, -4, 2.5}, .look_at = {0.1, 0, -0.1}, .up = {0, 0, 1}};
constexpr Camera inside{.eye = {0.3, -0.4, 0.2}, .look_at = {0.1, 0, -0.1}, .up = {0, 0, 1}};

/// A tile of some scene's picture, and its rays.
struct SomeTile {
    Scene scene;
    TraceFrame frame;
    Tile tile{.col = 64, .row = 64, .cols = 64, .rows = 64};
    TileRays rays;

    SomeTile(const std::string& text, const Camera& camera)
        : scene(scene_of(text, Box::cube(1.5))),
          frame(trace_frame(scene, scene.surfaces.front(), ViewFrame(camera),
                            {.width = 192, .height = 192}, {})),
          rays(frame, tile) {}
    SomeTile(const SomeTile&) = delete;
};

class RayStretches : public testing::Test {
protected:
    double between(double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random_);
    }

private:
    std::mt19937 random_{7};
};

/// The ray of a place as origin + s direction, the origin at s = 0.
struct Line {
    glm::dvec3 origin, direction;

    Line(const TileRays& rays, double col, double row)
        : origin(rays.point(col, row, 0.0)), direction(rays.point(col, row, 1.0) - origin) {}
};

TEST_F(RayStretches, TheLeastOfASphereIsOnTheWayPastItsCentre) {
    const UpwardRounding upward;
    const SomeTile some("x^2 + y^2 + z^2 = 0.25", aslant);
    // More than are searched at once, and no whole number of vectors.
    std::vector<RayStretch> stretches;
    for (int i = 0; i < 301; ++i)
        stretches.push_back({.col = between(-0.5, 63.5),
                             .row = between(-0.5, 63.5),
                             .from = between(-2.0, -0.7),
                             .to = between(0.7, 2.0)});
    Counters counters;
    find_least(some.frame, some.rays, stretches, counters);
    for (const RayStretch& stretch : stretches) {
        const Line line(some.rays, stretch.col, stretch.row);
        const double square = glm::dot(line.direction, line.direction);
        const double at = -glm::dot(line.origin, line.direction) / square;
        const auto f = [&](double s) {
            const glm::dvec3 x = line.origin + s * line.direction;
            return glm::dot(x, x) - 0.25;
        };
        ASSERT_NEAR(stretch.near, f(stretch.from), 1e-12);
        ASSERT_NEAR(stretch.far, f(stretch.to), 1e-12);
        ASSERT_TRUE(stretch.inner);
        ASSERT_NEAR(stretch.least, f(at), 1e-6);
        ASSERT_NEAR(stretch.at, at, 1e-3);
        // So much does the least change to the neighbouring rays.
        const Line right(some.rays, stretch.col + 1.0, stretch.row);
        const glm::dvec3 there = right.origin + stretch.at * right.direction;
        ASSERT_NEAR(stretch.by_col, glm::dot(there, there) - 0.25 - stretch.least, 2e-4);
    }
}

TEST_F(RayStretches, AKinkIsFoundWhereTheTangentsMeet) {
    const UpwardRounding upward;
    const SomeTile some("abs(x + 0.3 y) = 0", aslant);
    std::vector<RayStretch> stretches;
    for (int i = 0; i < 40; ++i)
        stretches.push_back(
            {.col = between(0.0, 63.0), .row = between(0.0, 63.0), .from = -3.0, .to = 3.0});
    Counters counters;
    find_least(some.frame, some.rays, stretches, counters);
    for (const RayStretch& stretch : stretches) {
        const Line line(some.rays, stretch.col, stretch.row);
        const double at =
            -(line.origin.x + 0.3 * line.origin.y) / (line.direction.x + 0.3 * line.direction.y);
        ASSERT_NEAR(stretch.at, at, 1e-5);
        ASSERT_NEAR(stretch.least, 0.0, 1e-5);
    }
}

TEST_F(RayStretches, TheFirstRootOfASphereIsFound) {
    const UpwardRounding upward;
    const SomeTile some("x^2 + y^2 + z^2 = 1", aslant);
    // With one root, and with both; in turns, so that they are sorted apart.
    std::vector<RayRoot> roots;
    for (int i = 0; i < 151; ++i)
        roots.push_back({.col = between(0.0, 63.0),
                         .row = between(0.0, 63.0),
                         .from = -2.0,
                         .to = i % 2 == 0 ? 0.0 : 2.0,
                         .several = i % 2 != 0});
    Counters counters;
    find_roots(some.frame, some.rays, roots, counters);
    for (const RayRoot& root : roots) {
        const Line line(some.rays, root.col, root.row);
        const double a = glm::dot(line.direction, line.direction);
        const double b = glm::dot(line.origin, line.direction) / a;
        const double c = (glm::dot(line.origin, line.origin) - 1.0) / a;
        const double s = -b - std::sqrt(b * b - c);
        ASSERT_TRUE(root.found);
        ASSERT_NEAR(root.s, s, 1e-5);
        const glm::dvec3 normal = line.origin + s * line.direction;
        ASSERT_NEAR(glm::dot(glm::normalize(root.gradient), normal), 1.0, 1e-4);
        ASSERT_NEAR(root.cosine, -glm::dot(normal, line.direction) / glm::length(line.direction),
                    1e-3);
    }
}

TEST_F(RayStretches, WithoutARootTheFarEndIsTold) {
    const UpwardRounding upward;
    const SomeTile some("x^2 + y^2 + z^2 = -1", aslant);
    std::vector<RayRoot> roots(3, {.col = 5.0, .row = 7.0, .from = -1.0, .to = 0.5});
    roots[1].several = true;
    Counters counters;
    find_roots(some.frame, some.rays, roots, counters);
    for (const RayRoot& root : roots) {
        EXPECT_FALSE(root.found);
        EXPECT_EQ(root.s, 0.5);
    }
}

TEST_F(RayStretches, DepthsOfManySquaresAreThoseOfEach) {
    const UpwardRounding upward;
    for (const Camera& camera : {aslant, inside}) {
        const SomeTile some("x = 0", camera);
        const double radius = 0.5 * some.rays.pixel();
        const std::size_t count = 61;
        SquareDepths squares;
        for (std::size_t i = 0; i < count; ++i) {
            squares.u[i] = some.rays.u(between(-60.0, 120.0));
            squares.v[i] = some.rays.v(between(-60.0, 120.0));
        }
        find_depths(some.rays, radius, count, squares);
        for (std::size_t i = 0; i < count; ++i) {
            const DepthRange found = squares.range(i);
            const DepthRange one = some.rays.depths(squares.u[i], squares.v[i], radius, radius);
            ASSERT_EQ(found.empty(), one.empty());
            if (one.empty()) continue;
            ASSERT_NEAR(found.enter_lo, one.enter_lo, 1e-12);
            ASSERT_NEAR(found.enter_hi, one.enter_hi, 1e-12);
            ASSERT_NEAR(found.exit_lo, one.exit_lo, 1e-12);
            ASSERT_NEAR(found.exit_hi, one.exit_hi, 1e-12);
        }
    }
}

TEST_F(RayStretches, AreClippedAsEachIs) {
    const UpwardRounding upward;
    const SomeTile some("x = 0", aslant);
    std::vector<RayStretch> stretches;
    for (int i = 0; i < 13; ++i)
        stretches.push_back({.col = between(-80.0, 140.0),
                             .row = between(-80.0, 140.0),
                             .from = between(-4.0, 0.0),
                             .to = between(0.0, 4.0)});
    const std::vector<RayStretch> before = stretches;
    clip_stretches(some.rays, stretches);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const TileRays::Stretch all =
            some.rays.stretch_inside(some.rays.u(before[i].col), some.rays.v(before[i].row));
        const double from = std::max(before[i].from, all.from);
        const double to = std::min(before[i].to, all.to);
        ASSERT_EQ(stretches[i].is_empty(), !(from <= to));
        if (stretches[i].is_empty()) continue;
        ASSERT_NEAR(stretches[i].from, from, 1e-12);
        ASSERT_NEAR(stretches[i].to, to, 1e-12);
    }
}

}  // namespace
}  // namespace zeroset::test::ray_stretches_test
