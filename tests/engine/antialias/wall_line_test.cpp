#include "engine/antialias/wall_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace zeroset::wall_line_test {
namespace {

constexpr SquareRay from{.x = -1.0, .y = 0.5};
constexpr SquareRay to{.x = 1.0, .y = -0.5};
constexpr double error = 1.0 / 512;

double part_of(const SquareRay& place) { return 0.5 * (place.x + 1.0); }

/// Gives the ray at a part of the way.
using RayAt = std::function<RayStretch(double)>;

RayStretch stretch(double length, double near, double far, bool has_root) {
    RayStretch ray{.col = 0.0, .row = 0.0, .from = 1.0, .to = 1.0 + length};
    ray.near = near;
    ray.far = far;
    ray.least = has_root ? -1.0 : 1.0;
    return ray;
}

struct Found {
    double wall;
    int rays;
};

Found search(const RayAt& ray_at, bool miss_has_f) {
    WallWay way(from, WallRay(ray_at(0.0), true), to, WallRay(ray_at(1.0), miss_has_f));
    int rays = 0;
    for (; !way.is_done(); ++rays)
        way.take(ray_at(part_of(way.next())));
    return {.wall = part_of(way.wall()), .rays = rays};
}

TEST(WallWay, FindsWhereRaysLeaveTheClipRegion) {
    for (const double wall : {0.003, 0.2, 0.5, 0.77, 0.998}) {
        const RayAt ray_at = [wall](double t) {
            return stretch(3.0 * (wall - t), 1.0, -1.0, t < wall);
        };
        const Found found = search(ray_at, false);
        EXPECT_NEAR(found.wall, wall, error) << wall;
        EXPECT_LE(found.rays, 4) << wall;
    }
}

TEST(WallWay, FindsWhereFAtOneEndChangesItsSign) {
    for (const double wall : {0.01, 0.3, 0.64, 0.99}) {
        const auto bent = [wall](double t) { return (t - wall) * (2.0 + 1.5 * t + t * t); };
        const Found at_exit =
            search([&](double t) { return stretch(1.0, 5.0, bent(t), t < wall); }, true);
        EXPECT_NEAR(at_exit.wall, wall, error) << wall;
        EXPECT_LT(at_exit.rays, 9) << wall;
        const Found at_entry =
            search([&](double t) { return stretch(1.0, -bent(t), -5.0, t < wall); }, true);
        EXPECT_NEAR(at_entry.wall, wall, error) << wall;
        EXPECT_LT(at_entry.rays, 9) << wall;
    }
}

TEST(WallWay, IsAsSureWhereHeightsMislead) {
    for (const double wall : {0.11, 0.5, 0.83}) {
        // f jumps, and is far larger on one side.
        const RayAt jump = [wall](double t) {
            return stretch(1.0, 1.0, t < wall ? -1e-6 : 1e6, t < wall);
        };
        EXPECT_NEAR(search(jump, true).wall, wall, error) << wall;
        // Nothing but whether there is a root.
        const RayAt blind = [wall](double t) { return stretch(1.0, 1.0, 1.0, t < wall); };
        EXPECT_NEAR(search(blind, true).wall, wall, error) << wall;
        const RayAt undefined = [wall](double t) {
            return stretch(1.0, std::nan(""), std::nan(""), t < wall);
        };
        EXPECT_NEAR(search(undefined, true).wall, wall, error) << wall;
    }
}

TEST(WallBetween, TakesWaysThatAreFarApart) {
    const std::array<WallPlace, 4> places{{{.at = {.x = -0.5, .y = -0.5}, .hit = true, .ray = 1},
                                           {.at = {.x = 0.5, .y = -0.5}, .hit = false, .ray = 2},
                                           {.at = {.x = -0.5, .y = 0.5}, .hit = true, .ray = 3},
                                           {.at = {.x = 0.5, .y = 0.5}, .hit = false, .ray = 4}}};
    const auto ways = wall_between(places);
    ASSERT_TRUE(ways);
    EXPECT_NE(ways->hit[0].ray, ways->hit[1].ray);
    EXPECT_NE(ways->miss[0].ray, ways->miss[1].ray);
    // The line x = 0, between them.
    const auto line = line_of_wall(places, {.x = 0.0, .y = -0.5}, {.x = 0.0, .y = 0.5});
    ASSERT_TRUE(line);
    EXPECT_LT(line->at(places[0].at), 0.0);
    EXPECT_GT(line->at(places[1].at), 0.0);
    // One that leaves a hit on the wrong side is none.
    EXPECT_FALSE(line_of_wall(places, {.x = 0.9, .y = -0.5}, {.x = -0.9, .y = 0.5}));
    EXPECT_FALSE(wall_between(std::span(places).subspan(1, 1)));
}

}  // namespace
}  // namespace zeroset::wall_line_test
