#include "papers/voxels/voxel_walk.hpp"

#include "tests/support/random_numbers.hpp"
#include "tests/support/voxel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

// The walk through voxels against a search of all of them.

namespace zeroset::test::voxel_walk_test {
namespace {

using Voxel = std::array<std::int32_t, 3>;

/// The line's part in a box of indices, as depths; empty: from is larger.
std::array<double, 2> part_within(const RayLine& line, const Voxel& lo, const Voxel& hi) {
    double from = line.from;
    double to = line.to;
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = (lo[i] - line.origin[i]) / line.direction[i];
        const double b = (hi[i] - line.origin[i]) / line.direction[i];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return {from, to};
}

struct Found {
    double from, length;
};

/// Where the line is for a while in voxels that hold the level, in order.
std::vector<Found> searched(const Volume& volume, const RayLine& line, double level) {
    const GridSize& size = volume.data().samples().size;
    std::vector<Found> found;
    const auto* const samples = static_cast<const float*>(volume.data().samples().data.get());
    for (std::int32_t k = 0; k + 1 < static_cast<std::int32_t>(size[2]); ++k) {
        for (std::int32_t j = 0; j + 1 < static_cast<std::int32_t>(size[1]); ++j) {
            for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(size[0]); ++i) {
                float lo = std::numeric_limits<float>::infinity();
                float hi = -lo;
                for (std::uint64_t corner = 0; corner < 8; ++corner) {
                    const auto at = ((static_cast<std::uint64_t>(k) + (corner >> 2U)) * size[1] +
                                     static_cast<std::uint64_t>(j) + (corner >> 1U & 1U)) *
                                        size[0] +
                                    static_cast<std::uint64_t>(i) + (corner & 1U);
                    lo = std::min(lo, samples[at]);
                    hi = std::max(hi, samples[at]);
                }
                if (static_cast<double>(lo) > level || static_cast<double>(hi) < level) continue;
                const auto [from, to] = part_within(line, {i, j, k}, {i + 1, j + 1, k + 1});
                if (to - from > 1e-6) found.push_back({from, to - from});
            }
        }
    }
    std::ranges::sort(found, {}, &Found::from);
    return found;
}

TEST(VoxelWalk, FindsTheVoxelsThatHoldTheLevelInTheirOrder) {
    RandomNumbers random(3);
    std::size_t all = 0;
    for (int n = 0; n < 300; ++n) {
        GridSize size{};
        for (auto& count : size)
            count = static_cast<std::uint64_t>(random.between(2, 23));
        const bool sparse = n % 2 == 0;
        const auto volume = volume_from(size, {}, [&](double, double, double) {
            return sparse && !random.one_in(60) ? 0.0 : random.uniform(-1, 1);
        });
        RayLine line{};
        for (std::size_t i = 0; i < 3; ++i) {
            line.direction[i] = random.uniform(-1, 1);
            line.origin[i] = random.uniform(0, static_cast<double>(size[i] - 1));
        }
        line.from = n % 3 == 0 ? 0 : -100;
        line.to = 100;
        const double level = 0.3;
        const auto walk = VoxelWalk::make({.volume = volume.get(), .level = level});
        std::vector<Found> walked;
        WalkingRay ray;
        VoxelRay voxel;
        if (walk->begin(line, ray)) {
            while (walk->next(ray, voxel)) {
                if (voxel.t_out > 1e-6F)
                    walked.push_back({ray.voxel_from, static_cast<double>(voxel.t_out)});
            }
        }
        const auto expected = searched(*volume, line, level);
        ASSERT_EQ(walked.size(), expected.size()) << n;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_NEAR(walked[i].from, expected[i].from, 1e-5) << n;
            EXPECT_NEAR(walked[i].length, expected[i].length, 1e-5) << n;
        }
        all += expected.size();
    }
    EXPECT_GT(all, 500U);
}

TEST(VoxelWalk, GoesAlongAxesAndFaces) {
    const auto volume =
        volume_from({6, 6, 6}, {}, [](double i, double, double) { return i - 2.5; });
    const auto walk = VoxelWalk::make({.volume = volume.get(), .level = 0});
    for (const double across : {0.0, 2.0, 2.5, 5.0}) {
        RayLine line{};
        line.origin = {-3, across, 5 - across};
        line.direction = {1, 0, 0};
        line.from = 0;
        line.to = 20;
        WalkingRay ray;
        VoxelRay voxel;
        ASSERT_TRUE(walk->begin(line, ray));
        ASSERT_TRUE(walk->next(ray, voxel));
        EXPECT_EQ(ray.voxel_from, 5);
        EXPECT_EQ(voxel.t_out, 1);
        EXPECT_FALSE(walk->next(ray, voxel));
    }
    RayLine beside{};
    beside.origin = {-3, 5.5, 2};
    beside.direction = {1, 0, 0};
    beside.to = 20;
    WalkingRay ray;
    EXPECT_FALSE(walk->begin(beside, ray));
}

}  // namespace
}  // namespace zeroset::test::voxel_walk_test
