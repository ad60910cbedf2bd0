#include "engine/measure/open_space.hpp"

#include "tests/support/random_numbers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

// Where a surface may be while parameters change, against points that surely are on it.

namespace zeroset::test::open_space_test {
namespace {

constexpr int levels = 5;

OpenSpace space_of(const std::string& text, double w_lo, double w_hi, bool jumps = false) {
    const Scene scene = scene_of(text, Box::cube(2));
    Uniforms uniforms;
    uniforms.set(0, w_lo, w_hi);
    return find_open_space(scene.surfaces.front().kernel, scene.clip, uniforms, levels, jumps, 2)
        .space;
}

/// Whether a point of the box is in one of the open cells.
bool holds(const OpenSpace& space, const glm::dvec3& point) {
    std::uint32_t cell = 0;
    for (int axis = 2; axis >= 0; --axis) {
        const double part = (point[axis] - space.box.lo[axis]) /
                            (space.box.hi[axis] - space.box.lo[axis]) * space.side;
        const auto at = static_cast<std::uint32_t>(std::clamp(part, 0.0, space.side - 1.0));
        cell = cell * static_cast<std::uint32_t>(space.side) + at;
    }
    return std::ranges::find(space.cells, cell) != space.cells.end();
}

double part_of(const OpenSpace& space) {
    return static_cast<double>(space.cells.size()) / std::pow(space.side, 3);
}

TEST(OpenSpace, HoldsTheSpheresOfAllRadii) {
    RandomNumbers random(20);
    const OpenSpace space = space_of("x^2 + y^2 + z^2 - w^2", 1.0, 1.1);
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 towards(random.uniform(-1, 1), random.uniform(-1, 1),
                                 random.uniform(-1, 1));
        if (glm::length(towards) < 0.1) continue;
        const double radius =
            random.one_in(3) ? random.between(0, 1) * 0.1 + 1.0 : random.uniform(1.0, 1.1);
        ASSERT_TRUE(holds(space, radius * glm::normalize(towards))) << i;
    }
    EXPECT_LT(part_of(space), 0.12) << "a shell through a grid of 32 cells";
}

TEST(OpenSpace, OfOneMomentIsPartOfThatOfMany) {
    for (const std::string text :
         {"x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + w", "sin(3 x) + sin(3 y) + sin(3 z) - w",
          "max(x^2 + y^2 + z^2 - 1 - w, w - x)", "sqrt(x) + y - w", "1 / (x - w) - z"}) {
        const OpenSpace all = space_of(text, 0.2, 0.5);
        const OpenSpace some = space_of(text, 0.3, 0.32);
        EXPECT_TRUE(std::ranges::includes(all.cells, some.cells) ||
                    std::ranges::all_of(some.cells,
                                        [&](std::uint32_t cell) {
                                            return std::ranges::find(all.cells, cell) !=
                                                   all.cells.end();
                                        }))
            << text;
        EXPECT_LT(part_of(some), 0.5) << text;
        EXPECT_FALSE(some.cells.empty()) << text;
    }
}

/// Between two points of which f has opposite signs there is a root of a polynomial.
TEST(OpenSpace, HoldsRootsOfRandomPolynomials) {
    RandomNumbers random(21);
    for (int formula = 0; formula < 30; ++formula) {
        std::array<double, 5> a{};
        for (double& number : a)
            number = std::round(random.uniform(-3, 3) * 64) / 64;
        const auto f = [&](const glm::dvec3& p, double w) {
            return a[0] * p.x * p.x * p.y + a[1] * p.y * p.y * w + a[2] * p.z * p.z * p.z +
                   a[3] * p.x * w * w + a[4] + w;
        };
        const auto number = [](double value) { return "(" + std::to_string(value) + ")"; };
        const OpenSpace space =
            space_of(number(a[0]) + "*x^2*y + " + number(a[1]) + "*y^2*w + " + number(a[2]) +
                         "*z^3 + " + number(a[3]) + "*x*w^2 + " + number(a[4]) + " + w",
                     -0.5, 0.25);
        for (int i = 0; i < 200; ++i) {
            const double w = random.uniform(-0.5, 0.25);
            const auto point = [&] {
                return glm::dvec3(random.uniform(-2, 2), random.uniform(-2, 2),
                                  random.uniform(-2, 2));
            };
            glm::dvec3 below = point();
            glm::dvec3 above = point();
            if (!(f(below, w) < 0 && f(above, w) > 0)) continue;
            for (int step = 0; step < 60; ++step) {
                const glm::dvec3 middle = 0.5 * (below + above);
                (f(middle, w) < 0 ? below : above) = middle;
            }
            ASSERT_TRUE(holds(space, below) || holds(space, above)) << formula << ": " << i;
        }
    }
}

TEST(OpenSpace, HoldsJumpsWhereTheyAreWanted) {
    // Within a cell: one at a border of cells is in the cell on either side of it, not in both.
    const glm::dvec3 at_jump(0.95, 0.3, -0.4);
    EXPECT_TRUE(holds(space_of("floor(x + 0.05) - 0.5", 0, 0, true), at_jump));
    EXPECT_EQ(space_of("x^2 + 1 + w", 0, 1).cells.size(), 0U);
    EXPECT_EQ(space_of("sqrt(x - 5)", 0, 0).cells.size(), 0U) << "nowhere defined";
}

}  // namespace
}  // namespace zeroset::test::open_space_test
