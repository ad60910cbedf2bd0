#include "engine/trace/voxels/ray_cubic.hpp"

#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Cubics along rays against the trilinear function itself, and what is proved of their roots
// against roots that are known.

namespace zeroset::test::ray_cubic_test {
namespace {

using Place = std::array<double, 3>;

double trilinear(const CellCorners& corners, const Place& at) {
    double sum = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        double weight = corners[corner];
        for (std::size_t axis = 0; axis < 3; ++axis)
            weight *= (corner >> axis & 1U) != 0 ? at[axis] : 1 - at[axis];
        sum += weight;
    }
    return sum;
}

Place between(const Place& a, const Place& b, double t) {
    Place place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        place[axis] = (1 - t) * a[axis] + t * b[axis];
    return place;
}

double value_of(const RayCubic& cubic, double t) {
    const double s = 1 - t;
    return s * s * s * cubic.b[0] + 3 * s * s * t * cubic.b[1] + 3 * s * t * t * cubic.b[2] +
           t * t * t * cubic.b[3];
}

struct RandomCell {
    CellCorners corners{};
    Place from{}, to{};

    explicit RandomCell(RandomNumbers& random) {
        for (double& corner : corners)
            corner = random.uniform(-1, 1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            from[axis] = random.uniform(0, 1);
            to[axis] = random.uniform(0, 1);
        }
    }
};

TEST(RayCubic, IsTheTrilinearFunctionAlongTheRay) {
    RandomNumbers random(1);
    for (int n = 0; n < 500; ++n) {
        const RandomCell cell(random);
        const RayCubic cubic = ray_cubic(cell.corners, cell.from, cell.to, 2, 5);
        for (int i = 0; i <= 8; ++i) {
            const double t = i / 8.0;
            EXPECT_NEAR(value_of(cubic, t), trilinear(cell.corners, between(cell.from, cell.to, t)),
                        1e-14);
        }
    }
}

TEST(CellSlopes, AreThoseOfTheTrilinearFunction) {
    RandomNumbers random(2);
    for (int n = 0; n < 200; ++n) {
        const RandomCell cell(random);
        const auto slopes = cell_slopes(cell.corners, cell.from);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // It is linear along each axis.
            Place low = cell.from;
            Place high = cell.from;
            low[axis] = 0;
            high[axis] = 1;
            EXPECT_NEAR(slopes[axis], trilinear(cell.corners, high) - trilinear(cell.corners, low),
                        1e-14);
        }
    }
}

/// The cubic scale (t - a) (t - b) (t - c) over [0, 1].
RayCubic with_roots(double a, double b, double c, double scale, double from = 0, double to = 1) {
    const auto blossom = [&](double x, double y, double z) {
        const double product = x * y * z;
        const double pairs = (x * y + y * z + z * x) / 3;
        const double sum = (x + y + z) / 3;
        return scale * (product - (a + b + c) * pairs + (a * b + b * c + c * a) * sum - a * b * c);
    };
    return {.b = {blossom(0, 0, 0), blossom(0, 0, 1), blossom(0, 1, 1), blossom(1, 1, 1)},
            .from = from,
            .to = to};
}

TEST(FirstRoot, FindsTheFirstOfThree) {
    RandomNumbers random(3);
    for (int n = 0; n < 2000; ++n) {
        std::array roots{random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5),
                         random.uniform(-0.5, 1.5)};
        std::ranges::sort(roots);
        const double scale = random.one_in(2) ? 1 : -1;
        FirstRoot search(1e-13, 1e-6);
        const bool found = search.look(with_roots(roots[0], roots[1], roots[2], scale));
        const auto* const first =
            std::ranges::find_if(roots, [](double root) { return root > 0 && root < 1; });
        const bool apart = roots[1] - roots[0] > 1e-3 && roots[2] - roots[1] > 1e-3;
        const bool near_end = std::ranges::any_of(
            roots, [](double root) { return std::abs(root) < 1e-4 || std::abs(root - 1) < 1e-4; });
        if (near_end) continue;
        ASSERT_EQ(found, first != roots.end());
        if (!found) continue;
        EXPECT_NEAR(search.depth(), *first, 2e-6);
        if (apart) {
            EXPECT_TRUE(search.is_proved());
            EXPECT_LE(search.from(), *first);
            EXPECT_GE(search.to(), *first);
            EXPECT_LE(search.to() - search.from(), 1e-6);
        }
    }
}

TEST(FirstRoot, DoesNotProveWhereItOnlyTouches) {
    FirstRoot search(1e-12, 1e-6);
    ASSERT_TRUE(search.look(with_roots(0.3, 0.3, 5, 1)));
    EXPECT_FALSE(search.is_proved());
    EXPECT_NEAR(search.depth(), 0.3, 1e-5);
}

TEST(FirstRoot, PassesWhatIsFartherFromZeroThanTheError) {
    FirstRoot search(1e-12, 1e-6);
    // Two roots that are a hair's breadth from being real
    RayCubic cubic = with_roots(0.3, 0.3, 5, -1);
    for (double& b : cubic.b)
        b += 1e-9;
    EXPECT_FALSE(search.look(cubic));
    EXPECT_FALSE(search.finish());
}

/// A root where two stretches meet is proved by signs on both.
TEST(FirstRoot, ProvesARootWhereStretchesMeet) {
    FirstRoot search(1e-12, 1e-3);
    EXPECT_FALSE(search.look(with_roots(1, 4, 5, 1, 0, 1)));
    ASSERT_TRUE(search.look(with_roots(0, 3, 4, 1, 1, 2)));
    EXPECT_TRUE(search.is_proved());
    EXPECT_LT(search.from(), 1);
    EXPECT_GT(search.to(), 1);
    EXPECT_NEAR(search.depth(), 1, 1e-3);
}

TEST(FirstRoot, DoesNotProveWhatTurnsBackWhereStretchesMeet) {
    FirstRoot search(1e-12, 1e-3);
    EXPECT_FALSE(search.look(with_roots(1, 4, 5, 1, 0, 1)));
    ASSERT_TRUE(search.look(with_roots(0, 3, 4, -1, 1, 2)));
    EXPECT_FALSE(search.is_proved());
    EXPECT_NEAR(search.depth(), 1, 1e-3);
}

TEST(FirstRoot, EndsAtAPlateauOfZeros) {
    FirstRoot search(1e-12, 1e-3);
    ASSERT_TRUE(search.look(RayCubic{.b = {0, 0, 0, 0}, .from = 2, .to = 3}));
    EXPECT_FALSE(search.is_proved());
    EXPECT_GE(search.depth(), 2);
    EXPECT_LE(search.depth(), 2.01);
}

TEST(FirstRoot, LeavesWhatIsOpenAtTheEnd) {
    FirstRoot search(1e-12, 1e-3);
    EXPECT_FALSE(search.look(with_roots(1, 4, 5, 1, 0, 1)));
    EXPECT_TRUE(search.finish());
    EXPECT_FALSE(search.is_proved());
    EXPECT_NEAR(search.depth(), 1, 1e-3);
}

}  // namespace
}  // namespace zeroset::test::ray_cubic_test
