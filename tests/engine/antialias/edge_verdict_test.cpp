#include "engine/antialias/edge_verdict.hpp"

#include "engine/antialias/cover_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

// Verdicts on squares by numbers alone: no kernel is asked, nothing is drawn.

namespace zeroset::test::edge_verdict_test {
namespace {

using Five = std::array<RayStretch, square_ray_count>;

/// Stretches in the middle of which f is least, as at a silhouette: there it is linear in the
/// place.
Five silhouette(const LinearOnSquare& least) {
    Five five{};
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        const double middle = least.at(square_rays[i]);
        five[i] = {.col = 0.0,
                   .row = 0.0,
                   .from = 0.0,
                   .to = 1.0,
                   .near = middle + 20.0,
                   .far = middle + 20.0,
                   .least = middle,
                   .at = 0.5,
                   .inner = true};
    }
    return five;
}

/// A square of a level, whose rays are all within the clip region.
struct Setting {
    CoverSquare square;
    Front front;
    Five five;

    Setting(const Five& stretches, int level) : five(stretches) {
        square.level = static_cast<std::uint8_t>(level);
        square.side = std::ldexp(1.0, -level);
        front.continuous = true;
        front.to = 1.0;
        front.inside_to = 1.0;
    }
    [[nodiscard]] EdgeSquare edge() const {
        return {.square = square, .front = front, .stretches = five, .samples = edge_samples(five)};
    }
    [[nodiscard]] EdgeVerdict inside(bool has_own_hit = false) const {
        return inside_verdict(edge(), has_own_hit);
    }
};

EdgeStep step_of(const EdgeVerdict& verdict) {
    const auto* const step = std::get_if<EdgeStep>(&verdict);
    EXPECT_NE(step, nullptr) << "a share is covered";
    return step == nullptr ? EdgeStep::DivideIntoRays : *step;
}

constexpr LinearOnSquare half{.value = 0.0, .by_x = 1.0, .by_y = 0.5};
constexpr LinearOnSquare corner{.value = 1.5, .by_x = -1.0, .by_y = -1.0};
constexpr LinearOnSquare everywhere{.value = -9.0, .by_x = 1.0, .by_y = 1.0};
constexpr LinearOnSquare nowhere{.value = 9.0, .by_x = 1.0, .by_y = 1.0};

TEST(EdgeVerdict, ALineCoversItsPartAndLeavesTheRest) {
    for (const auto& [line, share] :
         {std::pair{half, 0.5}, std::pair{corner, 1.0 / 32}, std::pair{-corner, 31.0 / 32}}) {
        const Setting at(silhouette(line), 0);
        const EdgeVerdict verdict = at.inside();
        const auto* const cover = std::get_if<EdgeCover>(&verdict);
        ASSERT_NE(cover, nullptr);
        EXPECT_NEAR(cover->share, share, 1e-9);
        EXPECT_NEAR(cover->rest.share, 1.0 - share, 1e-9);
        EXPECT_EQ(cover->certificate, Certificate::Certified);
        EXPECT_LE(line.at(cover->place), 0.0) << "the sample is in the part";
        for (std::size_t i = 0; i < square_ray_count; ++i)
            EXPECT_EQ(cover->rest.misses[i], line.at(square_rays[i]) > 0.0) << i;
    }
}

TEST(EdgeVerdict, APixelsOwnHitStandsForItWhereAllRaysHaveRoots) {
    Setting at(silhouette(everywhere), 0);
    const EdgeVerdict verdict = at.inside(true);
    ASSERT_TRUE(std::holds_alternative<EdgeCover>(verdict)) << "its colours may change";
    EXPECT_EQ(std::get<EdgeCover>(verdict).share, 1.0);
    at.front.calm = true;
    EXPECT_EQ(step_of(at.inside(true)), EdgeStep::LeavePlain);
    const Setting edge(silhouette(half), 0);
    EXPECT_TRUE(std::holds_alternative<EdgeCover>(edge.inside(true)));
}

TEST(EdgeVerdict, CreasesAreSoughtWhereAllRaysHaveRootsThatNoLineTellsOf) {
    Five five = silhouette(everywhere);
    five[1].least = five[4].least = -2.0;
    for (int level = 0; level < last_color_level; ++level)
        EXPECT_EQ(step_of(Setting(five, level).inside()), EdgeStep::SeekCreases) << level;
}

TEST(EdgeVerdict, NothingIsSeenWhereFStaysAway) {
    EXPECT_EQ(step_of(Setting(silhouette(nowhere), first_flat_level).inside()), EdgeStep::Pass);
}

TEST(EdgeVerdict, LongStretchesAreDividedInWhichRootsMayHide) {
    Five ends = silhouette(nowhere);
    for (RayStretch& ray : ends) {
        ray.inner = false;
        ray.at = ray.to;
        ray.far = ray.least;
    }
    EXPECT_EQ(step_of(Setting(ends, 0).inside()), EdgeStep::Divide);
}

/// Rays with roots and without in turn.
Five in_turn() {
    Five five = silhouette(nowhere);
    for (const std::size_t i : {std::size_t{1}, std::size_t{4}}) {
        five[i].least = -1.0;
        five[i].near = five[i].far = 1.0;
    }
    return five;
}

TEST(EdgeVerdict, AnEdgeWithoutANameIsDividedDownToTheLastLevel) {
    for (int level = 0; level <= last_edge_level; ++level) {
        const Setting at(in_turn(), level);
        EXPECT_EQ(step_of(at.inside()), EdgeStep::Rough);
        const EdgeVerdict verdict = rough_verdict(at.edge(), false);
        if (level < last_edge_level) {
            EXPECT_EQ(step_of(verdict), EdgeStep::Divide);
            continue;
        }
        const auto* const cover = std::get_if<EdgeCover>(&verdict);
        ASSERT_NE(cover, nullptr);
        EXPECT_EQ(cover->share, 2.0 / 5);
        EXPECT_NEAR(cover->rest.share, 3.0 / 5, 1e-15);
        EXPECT_EQ(cover->certificate, Certificate::Certified);
    }
}

TEST(EdgeVerdict, WhereFMayJumpRaysAreAskedOneByOne) {
    for (int level = 0; level <= last_broken_level; ++level) {
        Setting at(silhouette(half), level);
        at.front.continuous = false;
        EXPECT_FALSE(may_be_touched(at.edge()));
        EXPECT_EQ(step_of(rough_verdict(at.edge(), false)),
                  level < last_broken_level ? EdgeStep::Divide : EdgeStep::DivideIntoRays);
    }
}

TEST(EdgeVerdict, ASheetThatIsTouchedEverywhereCoversItsSquareUndecided) {
    Five five = silhouette({.value = 0.0, .by_x = 0.0, .by_y = 0.0});
    for (RayStretch& ray : five)
        ray.least = 1e-300;
    const Setting at(five, 0);
    const EdgeVerdict verdict = rough_verdict(at.edge(), true);
    const auto* const cover = std::get_if<EdgeCover>(&verdict);
    ASSERT_NE(cover, nullptr);
    EXPECT_EQ(cover->share, 1.0);
    EXPECT_EQ(cover->rest.share, 0.0);
    EXPECT_EQ(cover->certificate, Certificate::Undecided);
}

TEST(EdgeVerdict, EdgesOfKinkedSheetsAreDividedFirst) {
    for (const int level : {0, last_kinked_edge_level}) {
        Setting at(silhouette(half), level);
        at.front.kinked = true;
        const EdgeVerdict verdict = line_verdict(at.edge(), half);
        EXPECT_EQ(std::holds_alternative<EdgeCover>(verdict), level == last_kinked_edge_level);
    }
}

TEST(EdgeVerdict, AtAWallALineStandsOnARayThatIsSurelyShown) {
    // Whole rays are inside of the clip region, or the wall cuts them.
    for (const bool is_inside : {true, false}) {
        Setting at(silhouette(corner - LinearOnSquare{.value = 1.0, .by_x = 0.0, .by_y = 0.0}), 3);
        if (!is_inside) at.front.inside_to = 0.5;
        const auto verdict = line_verdict(at.edge(), half);
        const auto* const cover = std::get_if<EdgeCover>(&verdict);
        ASSERT_NE(cover, nullptr);
        const bool is_ray = std::ranges::any_of(square_rays, [&](const SquareRay& ray) {
            return ray.x == cover->place.x && ray.y == cover->place.y;
        });
        EXPECT_EQ(is_ray, !is_inside);
    }
}

}  // namespace
}  // namespace zeroset::test::edge_verdict_test
