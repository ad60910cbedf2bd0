#include "engine/volume/volume.hpp"

#include "tests/engine/volume/made_of_samples.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace zeroset::test::volume_test {
namespace {

TEST(Volume, IsLinearBetweenSamples) {
    const auto volume = linear_volume();
    EXPECT_DOUBLE_EQ(value_at(*volume, {1.5, 0.25, 3.75})[0], 1.5 + 2.5 + 375);
    EXPECT_DOUBLE_EQ(value_at(*volume, {3, 2, 4})[0], 423);
    EXPECT_EQ(value_at(*volume, {0.5, 1.5, 2.5})[1], 1);
    EXPECT_EQ(value_at(*volume, {0.5, 1.5, 2.5})[2], 10);
    EXPECT_EQ(value_at(*volume, {0.5, 1.5, 2.5})[3], 100);
}

TEST(Volume, IsBeyondItsGridWhatIsAskedFor) {
    const std::array<double, 3> beyond{-1, 5, 1.5};
    EXPECT_TRUE(std::isnan(value_at(*linear_volume(), beyond)[0]));
    const auto edge = value_at(*linear_volume({.outside = Outside::Edge}), beyond);
    EXPECT_DOUBLE_EQ(edge[0], 0 + 20 + 150);
    EXPECT_EQ(edge[1], 0);
    EXPECT_EQ(edge[2], 0);
    EXPECT_EQ(edge[3], 100);
    const auto seven =
        value_at(*linear_volume({.outside = Outside::Constant, .constant = 7}), beyond);
    EXPECT_EQ(seven[0], 7);
    EXPECT_EQ(seven[3], 0);
}

TEST(Volume, LiesWhereItsGeometrySays) {
    const Geometry place{.world_from_index = {{{0, -2, 0}, {1.5, 0, 0}, {0, 0, 3}}},
                         .origin = {10, 20, 30}};
    std::vector<float> numbers(3 * 4 * 5);
    numbers[2 + 3 * (1 + 4 * 3)] = 1;  // at (2, 1, 3)
    const auto volume = volume_of(samples_of({3, 4, 5}, numbers, SampleType::Float), place);
    const auto point = world_point(place, {2, 1, 3});
    EXPECT_EQ(point, (std::array{10.0 - 2, 20.0 + 3, 30.0 + 9}));
    EXPECT_NEAR(value_at(*volume, point)[0], 1, 1e-13);
    EXPECT_EQ(volume->data().bounds(), (std::array{4.0, 20.0, 30.0, 10.0, 23.0, 42.0}));
}

TEST(Volume, IsUndefinedInCellsWithAHole) {
    std::vector<float> numbers(4 * 4 * 4, 1);
    numbers[0] = std::numeric_limits<float>::quiet_NaN();
    numbers[3] = std::numeric_limits<float>::infinity();
    const auto volume = volume_of(samples_of({4, 4, 4}, numbers, SampleType::Float), {});
    EXPECT_TRUE(std::isnan(value_at(*volume, {0.5, 0.5, 0.5})[0]));
    EXPECT_TRUE(std::isnan(value_at(*volume, {2.5, 0.5, 0.5})[0]));
    EXPECT_EQ(value_at(*volume, {1.5, 0.5, 0.5})[0], 1);
    EXPECT_TRUE(volume->data().range().holes);
    EXPECT_EQ(volume->data().range().hi, 1);
}

TEST(Volume, RefusesWhatIsNoVolume) {
    const std::vector<float> numbers(64, 1);
    const auto error = [&](const GridSize& size, const Geometry& place) {
        const auto data = VolumeData::make(samples_of(size, numbers, SampleType::Float), place);
        return data ? std::string() : data.error();
    };
    EXPECT_EQ(error({64, 1, 1}, {}),
              "it has 64 x 1 x 1 samples; a volume needs two along each axis");
    EXPECT_EQ(error({4, 4, 4}, {.world_from_index = {{{1, 1, 0}, {1, 1, 0}, {0, 0, 1}}}}),
              "its axes lie in one plane or are no finite numbers");
    const std::vector<float> holes(64, std::numeric_limits<float>::quiet_NaN());
    const auto data = VolumeData::make(samples_of({4, 4, 4}, holes, SampleType::Float), {});
    EXPECT_EQ(data.error(), "none of its samples is a finite number");
}

}  // namespace
}  // namespace zeroset::test::volume_test
