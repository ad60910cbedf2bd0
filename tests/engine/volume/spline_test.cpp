#include "engine/volume/spline.hpp"

#include "engine/real/rounding.hpp"
#include "engine/volume/made_volumes.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/sample_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace zeroset::test::spline_test {
namespace {

template <class Sample>
std::shared_ptr<const VolumeData> data_of(const GridSize& size, std::vector<Sample> numbers,
                                          SampleType type) {
    const auto kept = std::make_shared<const std::vector<Sample>>(std::move(numbers));
    return VolumeData::make({.type = type,
                             .size = size,
                             .data = std::shared_ptr<const void>(kept, kept->data())},
                            {})
        .value();
}

/// Each sample from its indices.
std::shared_ptr<const VolumeData> data_from(const GridSize& size, auto value) {
    std::vector<double> numbers;
    for (std::uint64_t k = 0; k < size[2]; ++k) {
        for (std::uint64_t j = 0; j < size[1]; ++j) {
            for (std::uint64_t i = 0; i < size[0]; ++i)
                numbers.push_back(
                    value(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
        }
    }
    return data_of(size, numbers, SampleType::Double);
}

std::shared_ptr<const Volume> spline_of(const std::shared_ptr<const VolumeData>& data,
                                        SplineKind kind = SplineKind::Interpolating,
                                        const VolumeOptions& options = {}) {
    return Volume::make(SplineData::of(data, kind).value(), options, "volume(\"test\")");
}

std::array<double, 4> value_at(const Field& field, const std::array<double, 3>& point,
                               int derivative = 0) {
    std::array<double, 4> answer{};
    field.values(derivative, point.data(), answer.data(), 1);
    return answer;
}

/// A cosine of whole periods between the mirrors at both ends.
double wave(double i, std::uint64_t count, int periods) {
    return std::cos(std::numbers::pi * periods * i / static_cast<double>(count - 1));
}

TEST(Spline, GoesThroughItsSamples) {
    RandomNumbers random(51);
    for (const GridSize& size :
         {GridSize{2, 2, 2}, GridSize{3, 2, 7}, GridSize{9, 5, 4}, GridSize{40, 3, 6}}) {
        const auto data =
            data_from(size, [&](double, double, double) { return random.uniform(-100, 100); });
        const auto volume = spline_of(data);
        for (std::uint64_t k = 0; k < size[2]; ++k) {
            for (std::uint64_t j = 0; j < size[1]; ++j) {
                for (std::uint64_t i = 0; i < size[0]; ++i) {
                    const std::array at{static_cast<double>(i), static_cast<double>(j),
                                        static_cast<double>(k)};
                    EXPECT_NEAR(value_at(*volume, at)[0], sample_at(*data, i, j, k), 1e-11);
                }
            }
        }
    }
}

TEST(Spline, KeepsFloatsToTheirLastDigits) {
    RandomNumbers random(52);
    constexpr GridSize size{12, 9, 10};
    std::vector<std::int16_t> numbers(size[0] * size[1] * size[2]);
    for (auto& number : numbers)
        number = static_cast<std::int16_t>(random.between(-3000, 3000));
    const auto data = data_of(size, numbers, SampleType::Int16);
    const auto volume = spline_of(data);
    EXPECT_EQ(volume->spline()->coefficients().type, SampleType::Float);
    for (int n = 0; n < 200; ++n) {
        const std::array at{random.below(12), random.below(9), random.below(10)};
        const double value =
            value_at(*volume, {static_cast<double>(at[0]), static_cast<double>(at[1]),
                               static_cast<double>(at[2])})[0];
        EXPECT_NEAR(value, sample_at(*data, at[0], at[1], at[2]), 3000 * 1e-6);
    }
}

/// Its closed form: of a wave the spline is, in each cell, off by its fourth derivative.
TEST(Spline, IsMirroredAtItsEnds) {
    constexpr GridSize size{33, 17, 25};
    const auto data = data_from(size, [&](double i, double j, double k) {
        return wave(i, 33, 2) + wave(j, 17, 1) * wave(k, 25, 3);
    });
    const auto volume = spline_of(data, SplineKind::Interpolating, {.outside = Outside::Edge});
    RandomNumbers random(53);
    for (int n = 0; n < 1000; ++n) {
        const std::array at{random.uniform(0, 32), random.uniform(0, 16), random.uniform(0, 24)};
        EXPECT_NEAR(value_at(*volume, at)[0],
                    wave(at[0], 33, 2) + wave(at[1], 17, 1) * wave(at[2], 25, 3), 1e-4);
    }
    const auto end = value_at(*volume, {0, 16, 24});
    EXPECT_NEAR(end[1], 0, 1e-12);
    EXPECT_NEAR(end[2], 0, 1e-12);
    EXPECT_NEAR(end[3], 0, 1e-12);
    EXPECT_NEAR(value_at(*volume, {-5, 16, 24})[0], value_at(*volume, {0, 16, 24})[0], 1e-12);
}

/// The error of a wave falls with the fourth power of the spacing.
TEST(Spline, ErrorFallsWithTheFourthPower) {
    const auto error = [](std::uint64_t count) {
        const auto data =
            data_from({count, 2, 2}, [&](double i, double, double) { return wave(i, count, 3); });
        const auto volume = spline_of(data);
        double largest = 0;
        for (int n = 0; n < 4000; ++n) {
            const double x = static_cast<double>(count - 1) * n / 4000.0;
            largest =
                std::max(largest, std::abs(value_at(*volume, {x, 0.5, 0})[0] - wave(x, count, 3)));
        }
        return largest;
    };
    const double coarse = error(31);
    const double fine = error(61);
    EXPECT_GT(coarse / fine, 14);
    EXPECT_LT(coarse / fine, 18);
}

TEST(Spline, BesideItsSamplesIsTheirWeightedMean) {
    constexpr GridSize size{3, 4, 5};
    const auto data = data_from(size, [](double i, double j, double k) {
        return i == 1 && j == 2 && k == 3 ? 216.0 : 0.0;
    });
    const auto volume = spline_of(data, SplineKind::Smoothing);
    EXPECT_NEAR(value_at(*volume, {1, 2, 3})[0], 64, 1e-12);  // (4/6)^3
    EXPECT_NEAR(value_at(*volume, {2, 2, 3})[0], 32, 1e-12);  // twice 1/6: mirrored
    EXPECT_NEAR(value_at(*volume, {1, 3, 3})[0], 32, 1e-12);
    EXPECT_NEAR(value_at(*volume, {1, 2, 2})[0], 16, 1e-12);
    EXPECT_NEAR(value_at(*volume, {1, 1.5, 3})[0], 46, 1e-12);  // 23/48 of 96
}

TEST(Spline, IsTwiceContinuouslyDifferentiable) {
    RandomNumbers random(54);
    const auto data =
        data_from({7, 8, 9}, [&](double, double, double) { return random.uniform(-1, 1); });
    const auto volume = spline_of(data);
    constexpr double step = 1e-9;
    for (int n = 0; n < 300; ++n) {
        std::array at{random.uniform(1, 5), random.uniform(1, 6), random.uniform(1, 7)};
        const std::size_t axis = random.below(3);
        at[axis] = std::round(at[axis]);
        auto before = at;
        auto after = at;
        before[axis] -= step;
        after[axis] += step;
        for (const int derivative :
             {0, derivative_by(1, 0, 0), derivative_by(0, 1, 0), derivative_by(0, 0, 2),
              derivative_by(2, 0, 0), derivative_by(1, 1, 0), derivative_by(0, 1, 1)}) {
            EXPECT_NEAR(value_at(*volume, before, derivative)[0],
                        value_at(*volume, after, derivative)[0], 1e-6);
        }
    }
}

TEST(Spline, SecondDerivativesAreThoseOfDifferences) {
    RandomNumbers random(55);
    const auto data =
        data_from({6, 6, 6}, [&](double, double, double) { return random.uniform(-1, 1); });
    const auto volume = spline_of(data);
    constexpr double step = 1e-5;
    for (int n = 0; n < 300; ++n) {
        const std::array at{random.uniform(0.1, 4.9), random.uniform(0.1, 4.9),
                            random.uniform(0.1, 4.9)};
        for (std::size_t by = 0; by < 3; ++by) {
            const int first = once_more_by(0, by);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                auto before = at;
                auto after = at;
                before[axis] -= step;
                after[axis] += step;
                const double slope =
                    (value_at(*volume, after, first)[0] - value_at(*volume, before, first)[0]) /
                    (2 * step);
                EXPECT_NEAR(value_at(*volume, at, first)[1 + axis], slope, 2e-4);
                EXPECT_EQ(value_at(*volume, at, once_more_by(first, axis))[0],
                          value_at(*volume, at, first)[1 + axis]);
            }
        }
    }
}

/// Over a part of a cell the enclosure is nearly the range; so it is where the part crosses a plane
/// of the grid.
TEST(Spline, EnclosuresOfSmallBoxesAreTight) {
    RandomNumbers random(56);
    const auto data =
        data_from({9, 9, 9}, [&](double, double, double) { return random.uniform(-1, 1); });
    const auto volume = spline_of(data);
    const UpwardRounding upward;
    double most = 0;
    for (int n = 0; n < 400; ++n) {
        std::array<double, 6> box{};
        std::array<double, 3> lo{};
        const double width = std::exp2(-random.uniform(4, 20));
        for (std::size_t i = 0; i < 3; ++i) {
            lo[i] = random.uniform(0.5, 7);
            if (random.one_in(2)) lo[i] = std::floor(lo[i]) + 1 - width * random.uniform();
            box[i] = -lo[i];
            box[i + 3] = lo[i] + width;
        }
        const auto found = answers(FieldRange(), *volume, 0, box);
        const auto slope = value_at(*volume, lo);
        const double expected =
            width * (std::abs(slope[1]) + std::abs(slope[2]) + std::abs(slope[3]));
        const double excess = found[0] + found[1] - expected;
        most = std::max(most, excess / (width * width));
        EXPECT_LE(excess, 20 * width * width + 1e-12);
    }
    EXPECT_GT(most, 0.1);
}

TEST(Spline, RefusesWhatItCannotGoThrough) {
    std::vector<float> numbers(27, 1);
    numbers[13] = std::numeric_limits<float>::quiet_NaN();
    const auto data = data_of({3, 3, 3}, numbers, SampleType::Float);
    EXPECT_EQ(SplineData::of(data, SplineKind::Interpolating).error(),
              "some of its samples are no finite numbers, through which no spline goes; type "
              "smooth for one beside the samples, or trilinear");
    const auto beside = spline_of(data, SplineKind::Smoothing);
    EXPECT_TRUE(std::isnan(value_at(*beside, {0, 0, 0})[0]));
    std::vector<float> large(27, -3e38F);
    for (std::size_t i = 0; i < large.size(); i += 2)
        large[i] = 3e38F;
    EXPECT_EQ(
        SplineData::of(data_of({3, 3, 3}, large, SampleType::Float), SplineKind::Interpolating)
            .error(),
        "its samples are too large for a spline through them");
}

TEST(Spline, IsGivenAgainWhileItLives) {
    const auto data = data_from({3, 3, 3}, [](double i, double, double) { return i; });
    const auto first = SplineData::of(data, SplineKind::Interpolating).value();
    EXPECT_EQ(first, SplineData::of(data, SplineKind::Interpolating).value());
    EXPECT_NE(first, SplineData::of(data, SplineKind::Smoothing).value());
}

/// The signal of Marschner and Lobb in closed form [MarLob94]: frequency 6, amplitude 1/4.
double marschner_lobb(const std::array<double, 3>& at) {
    const double r = std::hypot(at[0], at[1]);
    const double ripple = std::cos(12 * std::numbers::pi * std::cos(std::numbers::pi * r / 2));
    return (1 - std::sin(std::numbers::pi * at[2] / 2) + 0.25 * (1 + ripple)) / 2.5;
}

struct Errors {
    double largest = 0, mean = 0;  ///< the mean is that of squares
};
Errors errors_of(const Volume& volume) {
    constexpr int steps = 50;
    Errors errors;
    int count = 0;
    for (int k = 0; k <= steps; ++k) {
        for (int j = 0; j <= steps; ++j) {
            for (int i = 0; i <= steps; ++i) {
                // Away from the border, where a mirror bends the ripples.
                const std::array at{1.8 * i / steps - 0.9, 1.8 * j / steps - 0.9,
                                    1.8 * k / steps - 0.9};
                const double error = std::abs(value_at(volume, at)[0] - marschner_lobb(at));
                errors.largest = std::max(errors.largest, error);
                errors.mean += error * error;
                ++count;
            }
        }
    }
    errors.mean = std::sqrt(errors.mean / count);
    return errors;
}

TEST(MadeVolume, CubicIsCloserToMarschnerAndLobbsSignalThanTrilinear) {
    const auto data = made_volume("marschner_lobb", 41).value();
    const Errors trilinear = errors_of(*Volume::make(data, {}, ""));
    const Errors cubic = errors_of(*spline_of(data));
    const Errors smooth = errors_of(*spline_of(data, SplineKind::Smoothing));
    EXPECT_NEAR(trilinear.largest, 0.084, 0.003);
    EXPECT_NEAR(cubic.largest, 0.0625, 0.003);
    EXPECT_NEAR(smooth.largest, 0.0875, 0.003);
    EXPECT_NEAR(trilinear.mean, 0.0339, 0.001);
    EXPECT_NEAR(cubic.mean, 0.0161, 0.001);
    EXPECT_NEAR(smooth.mean, 0.0466, 0.001);
}

}  // namespace
}  // namespace zeroset::test::spline_test
