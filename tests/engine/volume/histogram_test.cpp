#include "engine/volume/histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <type_traits>
#include <vector>

namespace zeroset::histogram_test {
namespace {

template <class Sample>
Samples grid_of(const std::vector<Sample>& values, SampleType type) {
    const auto kept = std::make_shared<std::vector<Sample>>(values);
    return {.type = type,
            .size = {values.size() / 4, 2, 2},
            .data = std::shared_ptr<const void>(kept, kept->data())};
}

template <class Sample>
std::optional<Histogram> counted(const std::vector<Sample>& values, SampleType type,
                                 std::size_t most) {
    SampleRange range;
    for (const Sample value : values) {
        const auto number = static_cast<double>(value);
        if (std::isfinite(number)) range.add({.lo = number, .hi = number});
    }
    return histogram_of(grid_of(values, type), range, most, false);
}

TEST(Histogram, HasAPartForEachWholeNumberWhereThereIsRoom) {
    const auto found = counted<std::uint8_t>({3, 3, 4, 6, 6, 6, 3, 5}, SampleType::UInt8, 100);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, (Histogram{.first = 2.5, .width = 1.0, .counts = {3, 1, 1, 3}}));
}

TEST(Histogram, HoldsAsManyWholeNumbersInEachPart) {
    std::vector<std::int16_t> values(40);
    std::iota(values.begin(), values.end(), std::int16_t{-20});
    const auto found = counted(values, SampleType::Int16, 16);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->width, 3.0);
    EXPECT_EQ(found->first, -20.5);
    EXPECT_EQ(found->counts,
              (std::vector<std::uint64_t>{3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 1}));
}

TEST(Histogram, CountsEveryFiniteSampleOnce) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const auto found = counted<float>({0.0F, 1.0F, 0.25F, 0.5F, none, infinite, 0.75F, 1.0F},
                                      SampleType::Float, 4);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, (Histogram{.first = 0.0, .width = 0.25, .counts = {1, 1, 1, 3}}))
        << "the largest is in the last part";
}

TEST(Histogram, IsOnePartOfEqualNumbers) {
    const auto found = counted<double>(std::vector<double>(8, 2.5), SampleType::Double, 4);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->counts, (std::vector<std::uint64_t>{8}));
}

TEST(Histogram, SpansTheLargestNumbers) {
    constexpr double largest = std::numeric_limits<double>::max();
    const auto found =
        counted<double>({-largest, largest, 0, 0, 0, 0, 0, 0}, SampleType::Double, 2);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->counts, (std::vector<std::uint64_t>{1, 7}));
    EXPECT_TRUE(std::isfinite(found->width));
}

TEST(Histogram, IsNothingWithoutNumbersOrWhenStopped) {
    const Samples samples = grid_of<float>(std::vector<float>(8, 1.0F), SampleType::Float);
    EXPECT_FALSE(histogram_of(samples, SampleRange(), 4, false));
    EXPECT_FALSE(histogram_of(samples, SampleRange{.lo = 1, .hi = 1}, 4, true));
}

TEST(DividingValue, LiesBetweenTwoKindsOfSamples) {
    // Air about 100, bodies about 600: in the middle of the parts that have none.
    Histogram histogram{.first = 0, .width = 10, .counts = std::vector<std::uint64_t>(100, 0)};
    for (std::size_t i = 5; i < 15; ++i)
        histogram.counts[i] = 900;
    for (std::size_t i = 55; i < 65; ++i)
        histogram.counts[i] = 100;
    EXPECT_DOUBLE_EQ(dividing_value(histogram), 350);
    EXPECT_EQ(dividing_value({.first = -4, .width = 2, .counts = {7}}), -3) << "one kind alone";
    EXPECT_DOUBLE_EQ(dividing_value({.first = 0, .width = 1, .counts = {9, 0, 0, 1}}), 2);
}

}  // namespace
}  // namespace zeroset::histogram_test
