#include "engine/trace/voxels/spline_ray.hpp"

#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// A cubic spline along rays against its definition: the sum of its coefficients times products of
// B-splines, which are written here as powers beyond knots.

namespace zeroset::test::spline_ray_test {
namespace {

using Place = std::array<double, 3>;

/// The cubic B-spline about 0.
double b_spline(double x) {
    const auto beyond = [&](double knot) { return std::pow(std::max(x - knot, 0.0), 3); };
    return (beyond(-2) - 4 * beyond(-1) + 6 * beyond(0) - 4 * beyond(1) + beyond(2)) / 6;
}

/// Coefficient i belongs to the place i - 1.
double spline_at(const CellCoefficients& cell, const Place& at) {
    double sum = 0;
    for (std::size_t n = 0; n < cell.size(); ++n) {
        const std::array of{n % 4, n / 4 % 4, n / 16};
        double weight = 1;
        for (std::size_t axis = 0; axis < 3; ++axis)
            weight *= b_spline(at[axis] - (static_cast<double>(of[axis]) - 1));
        sum += weight * cell[n];
    }
    return sum;
}

CellCoefficients random_cell(RandomNumbers& random) {
    CellCoefficients cell{};
    for (double& number : cell)
        number = random.uniform(-1, 1);
    return cell;
}

Place random_place(RandomNumbers& random) {
    return {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
}

double value_of(const RayNonic& f, double t) {
    std::array<double, 10> b = f.b;
    for (std::size_t left = b.size() - 1; left > 0; --left) {
        for (std::size_t i = 0; i < left; ++i)
            b[i] += t * (b[i + 1] - b[i]);
    }
    return b[0];
}

TEST(SplineRay, IsTheSplineAlongTheRay) {
    RandomNumbers random(3);
    for (int n = 0; n < 300; ++n) {
        const CellCoefficients cell = random_cell(random);
        const Place from = random_place(random);
        const Place to = random_place(random);
        const RayNonic f = ray_nonic(cell, from, to, 2, 5);
        EXPECT_EQ(f.from, 2);
        EXPECT_EQ(f.to, 5);
        for (const double t : {0.0, 0.2, 0.51, 0.9, 1.0}) {
            Place at{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                at[axis] = from[axis] + t * (to[axis] - from[axis]);
            EXPECT_NEAR(value_of(f, t), spline_at(cell, at), 1e-14) << n;
        }
    }
}

TEST(SplineRay, LiesBetweenItsCoefficients) {
    RandomNumbers random(4);
    for (int n = 0; n < 300; ++n) {
        const CellCoefficients cell = random_cell(random);
        const auto [least, largest] = std::ranges::minmax(cell);
        const RayNonic f = ray_nonic(cell, random_place(random), random_place(random), 0, 1);
        for (const double b : f.b) {
            EXPECT_GE(b, least);
            EXPECT_LE(b, largest);
        }
    }
}

TEST(SplineRay, HasTheSlopesOfTheSpline) {
    RandomNumbers random(5);
    for (int n = 0; n < 100; ++n) {
        const CellCoefficients cell = random_cell(random);
        const Place at = random_place(random);
        const Place slopes = cell_slopes(cell, at);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            constexpr double step = 1e-4;
            Place below = at;
            Place above = at;
            below[axis] -= step;
            above[axis] += step;
            EXPECT_NEAR(slopes[axis],
                        (spline_at(cell, above) - spline_at(cell, below)) / (2 * step), 1e-6);
        }
    }
}

/// The first root of a search in stretches, by signs at many places.
TEST(SplineRay, FirstRootsAreThoseOfItsSigns) {
    RandomNumbers random(6);
    int roots = 0;
    for (int n = 0; n < 1000; ++n) {
        const CellCoefficients cell = random_cell(random);
        const RayNonic f = ray_nonic(cell, random_place(random), random_place(random), 0, 1);
        constexpr int places = 4000;
        double expected = 2;
        for (int i = 0; i < places && expected > 1; ++i) {
            const double t = (i + 0.5) / places;
            if (value_of(f, 0) * value_of(f, t) < 0) expected = t;
        }
        FirstRoot root(1e-13, 1e-5);
        const bool ended = root.look(f) || root.finish();
        EXPECT_EQ(ended, expected < 2) << n;
        if (!ended || expected > 1) continue;
        ++roots;
        EXPECT_TRUE(root.is_proved());
        EXPECT_NEAR(root.depth(), expected, 1.0 / places);
        EXPECT_LE(root.to() - root.from(), 1e-5);
        EXPECT_LT(value_of(f, root.from()) * value_of(f, root.to()), 0);
    }
    EXPECT_GT(roots, 100);
}

}  // namespace
}  // namespace zeroset::test::spline_ray_test
