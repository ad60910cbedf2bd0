#include "engine/antialias/edge_fit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>

namespace zeroset::test::edge_fit_test {
namespace {

using Five = std::array<RayStretch, square_ray_count>;

/// Stretches from 0 to 1, f being linear in the place at both ends, and least at one of them.
Five stretches_of(const LinearOnSquare& near, const LinearOnSquare& far) {
    Five five{};
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        five[i].to = 1.0;
        five[i].near = near.at(square_rays[i]);
        five[i].far = far.at(square_rays[i]);
    }
    return five;
}

constexpr LinearOnSquare far_from_zero{.value = 9.0, .by_x = 1.0, .by_y = -1.0};
/// Above 0 at all five rays; below in a corner, a triangle of 1/32 of the square.
constexpr LinearOnSquare cut_corner{.value = 1.5, .by_x = -1.0, .by_y = -1.0};

TEST(EdgeFit, RootsAreWhereOneEndChangesItsSign) {
    for (const bool at_far_end : {false, true}) {
        for (const double sign : {1.0, -1.0}) {
            Five five = at_far_end ? stretches_of(far_from_zero, cut_corner)
                                   : stretches_of(cut_corner, far_from_zero);
            for (RayStretch& ray : five) {
                ray.near *= sign;
                ray.far *= sign;
            }
            const auto samples = one_end_samples(five);
            ASSERT_TRUE(samples);
            EXPECT_EQ(samples->roots(), 0U);
            const auto fit = fit_edge(*samples, 1e-6, false);
            ASSERT_TRUE(fit);
            EXPECT_NEAR(part_below_zero(*fit).share, 1.0 / 32, 1e-9);
        }
    }
}

TEST(EdgeFit, NothingIsSaidWhereBothEndsMayChangeTheirs) {
    EXPECT_FALSE(one_end_samples(stretches_of(cut_corner, cut_corner)));
}

TEST(EdgeFit, NothingIsSaidWhereARayHasARootOrMayHaveTwo) {
    Five five = stretches_of(cut_corner, far_from_zero);
    five[3].near = -five[3].near;
    EXPECT_FALSE(one_end_samples(five));
    five = stretches_of(cut_corner, far_from_zero);
    five[2].inner = true;
    EXPECT_FALSE(one_end_samples(five));
}

TEST(EdgeFit, NothingIsSaidOfRaysBesideTheClipRegion) {
    Five five = stretches_of(cut_corner, far_from_zero);
    five[4].from = 2.0;
    EXPECT_FALSE(one_end_samples(five));
    five = stretches_of(cut_corner, far_from_zero);
    five[1].far = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(one_end_samples(five));
}

constexpr LinearOnSquare entry{.value = 2.0, .by_x = 0.5, .by_y = -0.25};

/// Stretches from a wall to one depth.
Five stretches_from_wall(double to) {
    Five five = stretches_of(cut_corner, far_from_zero);
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        five[i].from = entry.at(square_rays[i]);
        five[i].to = to;
    }
    return five;
}

TEST(EdgeFit, EndsAreEvenWhereTheyAreInOneWall) {
    // Rays may enter beyond the far end, too.
    for (const double to : {9.0, 2.1}) {
        Five five = stretches_from_wall(to);
        std::array<RayStretch, square_corners.size()> corners{};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corners[i].from = entry.at(square_corners[i]);
            corners[i].to = to;
        }
        EXPECT_TRUE(are_ends_even(five, corners));
        // Another wall cuts a corner; a ray; the far end.
        for (RayStretch* ray : {&corners[2], &five[3]}) {
            ray->from += 0.1;
            EXPECT_FALSE(are_ends_even(five, corners));
            ray->from -= 0.1;
            ray->to -= 0.1;
            EXPECT_FALSE(are_ends_even(five, corners));
            ray->to = to;
        }
        EXPECT_TRUE(are_ends_even(five, corners));
    }
}

TEST(EdgeFit, AWallCutsWhereFHasTheOtherSignInIt) {
    for (const double sign : {1.0, -1.0}) {
        for (const WallEnd& wall : {entry_wall, exit_wall}) {
            // A half of the square, and a corner that no ray is in.
            for (const LinearOnSquare& in_wall :
                 {LinearOnSquare{.value = 0.0, .by_x = 1.0, .by_y = 0.5}, cut_corner}) {
                Five five = stretches_of(far_from_zero, far_from_zero);
                for (std::size_t i = 0; i < square_ray_count; ++i) {
                    five[i].*wall.f = sign * in_wall.at(square_rays[i]);
                    five[i].*wall.other_f *= sign;
                }
                const auto samples = wall_samples(five, wall);
                ASSERT_TRUE(samples);
                const auto fit = fit_edge(*samples, 1e-6, false);
                ASSERT_TRUE(fit);
                const SquarePart part = part_below_zero(*fit);
                const SquarePart wanted = part_below_zero(in_wall);
                EXPECT_NEAR(part.share, wanted.share, 1e-12);
                EXPECT_NEAR(part.x, wanted.x, 1e-12);
                // Between the ends of a ray in the part f goes through 0.
                for (std::size_t i = 0; i < square_ray_count; ++i) {
                    if (samples->height[i] > 0.0) continue;
                    EXPECT_EQ(samples->bracket(five, i).to, five[i].to);
                    EXPECT_LE(five[i].near * five[i].far, 0.0);
                }
            }
        }
    }
}

TEST(EdgeFit, AWallTellsNothingWhereFIsNotSureBesideIt) {
    // The other end is above 0 at all rays, but not at a corner.
    EXPECT_FALSE(wall_samples(stretches_of(cut_corner, cut_corner), entry_wall));
    Five five = stretches_from_wall(9.0);
    EXPECT_TRUE(wall_samples(five, entry_wall));
    five[2].inner = true;
    EXPECT_FALSE(wall_samples(five, entry_wall));
    five = stretches_from_wall(9.0);
    five[1].near = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(wall_samples(five, entry_wall));
    // A ray enters beyond the far end. Where it may have a root then is not known.
    five = stretches_from_wall(9.0);
    five[4].to = 0.0;
    EXPECT_TRUE(wall_samples(five, entry_wall));
    five[4].near = -five[4].near;
    EXPECT_FALSE(wall_samples(five, entry_wall));
}

TEST(EdgeFit, ARayBesideTheOthersEndsInTheSameWall) {
    const Five five = stretches_from_wall(9.0);
    const SquareRay place{.x = 0.75, .y = -0.5};
    const RayStretch stretch = stretch_at(five, place);
    EXPECT_NEAR(stretch.from, entry.at(place), 1e-12);
    EXPECT_EQ(stretch.to, 9.0);
}

TEST(EdgeFit, LinesAreSteepByAnyNumbers) {
    for (const double scale : {1.0, 1e-200, 1e200}) {
        const LinearOnSquare line{.value = 0.0, .by_x = 3 * scale, .by_y = -4 * scale};
        EXPECT_NEAR(line.slope() / scale, 5.0, 1e-12);
    }
    EXPECT_EQ((LinearOnSquare{.value = 1.0, .by_x = 0.0, .by_y = 0.0}).slope(), 0.0);
}

TEST(EdgeFit, ASlopeIsOneWhereItIsNearlyTheSameAtAllRays) {
    Five five = stretches_of(cut_corner, far_from_zero);
    for (RayStretch& ray : five) {
        ray.by_col = 3.0;
        ray.by_row = -4.0;
    }
    five[2].by_col = 3.2;
    EXPECT_TRUE(is_one_slope(five));
    five[2].by_row = -4.3;
    EXPECT_FALSE(is_one_slope(five));
    five[2] = five[1];
    five[0].by_col = -3.0;
    EXPECT_FALSE(is_one_slope(five));
    five[0].by_col = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_one_slope(five));
}

}  // namespace
}  // namespace zeroset::test::edge_fit_test
