#include "engine/trace/voxels/lane_roots.hpp"

#include "engine/trace/voxels/ray_cubic.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

// Many rays at once against the same rays one by one, whose cubics ray_cubic_test.cpp checks.

namespace zeroset::test::lane_roots_test {
namespace {

using Place = std::array<double, 3>;

constexpr double error = 1e-12;
constexpr double finest = 1e-4;

/// Rays from about the origin, more or less along the first axis, across which the layers are.
struct Bundle {
    IndexRays rays;
    IndexMap map{.index_from_world = {{{2, 0.3, -0.1}, {0.2, 3, 0.4}, {-0.5, 0.1, 1.5}}},
                 .shift = {0, 0, 0}};

    explicit Bundle(RandomNumbers& random, bool up) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            rays.base[axis] = random.uniform(3, 9);
            rays.right[axis] = random.uniform(-1, 1);
            rays.up[axis] = random.uniform(-1, 1);
            rays.forward[axis] = random.uniform(-0.9, 0.9);
        }
        rays.forward[0] = up ? 2 : -2;
        rays.distance = random.uniform(0, 5);
    }
    [[nodiscard]] BundleSearch search() const {
        return {.rays = rays,
                .map = map,
                .axes = {.i = 1, .j = 2, .k = 0},
                .enter = -100,
                .exit = 100,
                .error = error,
                .finest = finest,
                .look_distance = 7,
                .sign = -1};
    }
};

LaneRays some_rays(RandomNumbers& random, std::size_t count) {
    LaneRays rays;
    rays.count = count;
    for (std::size_t lane = 0; lane < count; ++lane) {
        rays.u[lane] = random.uniform(-0.3, 0.3);
        rays.v[lane] = random.uniform(-0.3, 0.3);
    }
    return rays;
}

Place place_of(const LaneRays& rays, std::size_t lane, double depth) {
    Place place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        place[axis] = rays.at[axis][lane] + depth * rays.along[axis][lane] - rays.cell[axis][lane];
    }
    return place;
}

bool has(std::uint32_t lanes, std::size_t lane) { return (lanes >> lane & 1U) != 0; }

/// Each stretch begins where the last one ended, and is in its cell.
void expect_whole_way(const BundleSearch& search, std::int32_t layer, LaneRays& rays) {
    std::uint32_t left = enter_layer(search, layer, rays);
    ASSERT_EQ(left, (1U << rays.count) - 1);
    LaneRays::Numbers reached = rays.from;
    LaneRays::Numbers ends = rays.to;
    for (int cells = 0; left != 0; ++cells) {
        ASSERT_LT(cells, 9);
        for (std::size_t lane = 0; lane < rays.count; ++lane) {
            if (!has(left, lane)) continue;
            EXPECT_EQ(rays.from[lane], reached[lane]);
            EXPECT_GE(rays.until[lane], rays.from[lane]);
            reached[lane] = rays.until[lane];
            for (const double depth : {rays.from[lane], rays.until[lane]}) {
                for (const double part : place_of(rays, lane, depth)) {
                    EXPECT_GE(part, -1e-12);
                    EXPECT_LE(part, 1 + 1e-12);
                }
            }
        }
        left = next_cells(search, left, rays);
    }
    for (std::size_t lane = 0; lane < rays.count; ++lane) {
        EXPECT_EQ(reached[lane], ends[lane]);
        const IndexRays::Ray ray = search.rays.ray(rays.u[lane], rays.v[lane]);
        const auto at = [&](double depth) { return ray.at[0] + depth * ray.along[0] - layer; };
        const auto [low, high] = std::minmax({at(rays.from[lane]), at(rays.to[lane])});
        EXPECT_LE(low, high);
        EXPECT_NEAR(at(ends[lane]), ray.along[0] > 0 ? 1 : 0, 1e-12);
    }
}

TEST(LaneRoots, GoThroughAllCellsOfALayer) {
    RandomNumbers random(3);
    for (int n = 0; n < 500; ++n) {
        const Bundle bundle(random, n % 2 == 0);
        LaneRays rays = some_rays(random, 1 + random.below(LaneRays::most));
        ASSERT_NO_FATAL_FAILURE(expect_whole_way(bundle.search(), random.between(-3, 12), rays));
    }
}

TEST(LaneRoots, LeaveOutRaysThatAreNotInTheRegionAllThroughALayer) {
    RandomNumbers random(4);
    const Bundle bundle(random, true);
    LaneRays rays = some_rays(random, LaneRays::most);
    ASSERT_EQ(enter_layer(bundle.search(), 5, rays), 0xffU);
    BundleSearch search = bundle.search();
    search.enter = std::nextafter(rays.from[3], 1e9);
    search.exit = rays.to[6];
    const std::uint32_t inside = enter_layer(search, 5, rays);
    for (std::size_t lane = 0; lane < LaneRays::most; ++lane) {
        EXPECT_EQ(has(inside, lane),
                  rays.from[lane] >= search.enter && rays.to[lane] <= search.exit);
    }
    EXPECT_FALSE(has(inside, 3));
}

/// Rays in a cell each, with corners of a kind.
class RaysInCells {
public:
    RaysInCells(RandomNumbers& random, int kind)
        : bundle_(random, true), rays_(some_rays(random, LaneRays::most)) {
        enter_layer(bundle_.search(), 4, rays_);
        for (std::size_t lane = 0; lane < LaneRays::most; ++lane) {
            const double shift = kind == 1 ? random.uniform(-2, 2) : 0;
            for (auto& corner : rays_.corners) {
                corner[lane] = random.uniform(-1, 1) + shift;
                if (kind == 2) corner[lane] = random.between(-1, 1);
                if (kind == 3) corner[lane] *= 1e-12;
            }
        }
    }
    void expect_as_one_by_one(LaneSides before) {
        const BundleSearch search = bundle_.search();
        LaneSides sides = before;
        std::uint32_t unclear = 0;
        constexpr std::uint32_t all = 0xff;
        const std::uint32_t roots = find_roots(search, all, rays_, sides, unclear);
        EXPECT_EQ(roots & unclear, 0U);
        for (std::size_t lane = 0; lane < LaneRays::most; ++lane) {
            CellCorners corners{};
            for (std::size_t corner = 0; corner < 8; ++corner)
                corners[corner] = rays_.corners[corner][lane];
            FirstRoot root(error, finest);
            if (has(before.above, lane)) root.begin_above();
            if (has(before.below, lane)) root.begin_below();
            const RayCubic f = ray_cubic(corners, place_of(rays_, lane, rays_.from[lane]),
                                         place_of(rays_, lane, rays_.until[lane]), rays_.from[lane],
                                         rays_.until[lane]);
            const bool ended = root.look(f);
            if (has(roots, lane)) {
                ++found;
                ASSERT_TRUE(ended && root.is_proved());
                expect_root(lane, corners, root.depth());
            } else if (!has(unclear, lane)) {
                ++without;
                EXPECT_FALSE(ended || root.is_open());
                EXPECT_EQ(has(sides.above, lane), f.b[0] > 0);
                EXPECT_EQ(has(sides.below, lane), f.b[0] < 0);
            } else {
                ++left;
                if (ended && root.is_proved()) ++proved_alone;
            }
        }
    }

    int found = 0, without = 0, left = 0, proved_alone = 0;

private:
    void expect_root(std::size_t lane, const CellCorners& corners, double depth) const {
        const double u = rays_.u[lane];
        const double v = rays_.v[lane];
        EXPECT_NEAR(rays_.distance[lane], (7 + depth) * std::sqrt(1 + u * u + v * v), finest);
        const Place slopes = cell_slopes(corners, place_of(rays_, lane, depth));
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum -= bundle_.map.index_from_world[axis][c] * slopes[axis];
            EXPECT_NEAR(rays_.gradient[c][lane], sum, 1e-3);
        }
    }

    Bundle bundle_;
    LaneRays rays_;
};

TEST(LaneRoots, AreThoseOfRaysOneByOne) {
    RandomNumbers random(5);
    std::array<int, 4> sum{};
    for (int n = 0; n < 2000; ++n) {
        RaysInCells rays(random, n % 4);
        LaneSides before;
        before.above = static_cast<std::uint32_t>(random.below(256));
        before.below = static_cast<std::uint32_t>(random.below(256)) & ~before.above;
        ASSERT_NO_FATAL_FAILURE(rays.expect_as_one_by_one(n % 8 < 4 ? LaneSides{} : before));
        for (const auto& [of, count] : {std::pair{0, rays.found}, std::pair{1, rays.without},
                                        std::pair{2, rays.left}, std::pair{3, rays.proved_alone}})
            sum[static_cast<std::size_t>(of)] += count;
    }
    EXPECT_GT(sum[0], 1000) << "roots";
    EXPECT_GT(sum[1], 1000) << "none";
    EXPECT_GT(sum[2], 100) << "neither";
    EXPECT_LT(sum[3], sum[0]) << "most are found at once";
}

}  // namespace
}  // namespace zeroset::test::lane_roots_test
