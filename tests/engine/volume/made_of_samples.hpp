#pragma once

#include "engine/volume/spline.hpp"
#include "engine/volume/volume.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Volumes of samples that tests make.

namespace zeroset::test {

template <class Sample>
Samples samples_of(const GridSize& size, std::vector<Sample> numbers, SampleType type) {
    const auto kept = std::make_shared<const std::vector<Sample>>(std::move(numbers));
    return {.type = type, .size = size, .data = std::shared_ptr<const void>(kept, kept->data())};
}

/// Trilinear; or a spline through the samples (1) or beside them (2), as are those with holes.
inline std::shared_ptr<const Volume> volume_of(const Samples& samples, const Geometry& place,
                                               const VolumeOptions& options = {},
                                               std::uint64_t spline = 0) {
    const auto data = VolumeData::make(samples, place);
    EXPECT_TRUE(data.has_value()) << data.error();
    const std::string text = "volume(\"test\")";
    if (spline == 0) return Volume::make(*data, options, text);
    const bool smooth = spline == 2 || (*data)->range().holes;
    return Volume::make(
        SplineData::of(*data, smooth ? SplineKind::Smoothing : SplineKind::Interpolating).value(),
        options, text);
}

/// x + 10 y + 100 z at the samples, and so between them.
inline std::shared_ptr<const Volume> linear_volume(const VolumeOptions& options = {}) {
    constexpr GridSize size{4, 3, 5};
    std::vector<std::int16_t> numbers;
    for (int k = 0; k < 5; ++k) {
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 4; ++i)
                numbers.push_back(static_cast<std::int16_t>(i + 10 * j + 100 * k));
        }
    }
    return volume_of(samples_of(size, numbers, SampleType::Int16), {}, options);
}

inline std::array<double, 4> value_at(const Field& field, const std::array<double, 3>& point,
                                      int derivative = 0) {
    std::array<double, 4> answer{};
    field.values(derivative, point.data(), answer.data(), 1);
    return answer;
}

}  // namespace zeroset::test
