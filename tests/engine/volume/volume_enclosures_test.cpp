#include "engine/real/processor.hpp"
#include "engine/real/rounding.hpp"
#include "engine/volume/spline.hpp"
#include "engine/volume/volume.hpp"
#include "tests/engine/volume/made_of_samples.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"
#include "tests/support/sample_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

// Answers of volumes about boxes and about single points, against each other.

namespace zeroset::test::volume_enclosures_test {
namespace {

/// A grid of any type, size, place and filling that finds faults.
std::shared_ptr<const Volume> random_volume(RandomNumbers& random) {
    GridSize size{};
    for (auto& count : size)
        count = static_cast<std::uint64_t>(random.between(2, random.one_in(3) ? 40 : 9));
    const std::uint64_t count = size[0] * size[1] * size[2];
    const bool sparse = random.one_in(3);
    const bool holes = random.one_in(3);
    const auto number = [&] {
        if (sparse && !random.one_in(9)) return 0.0;
        return random.one_in(4) ? 100.0 : std::floor(random.uniform(-100, 100));
    };
    Samples samples;
    if (random.one_in(2)) {
        std::vector<float> numbers;
        for (std::uint64_t i = 0; i < count; ++i)
            numbers.push_back(static_cast<float>(number() * 0.37));
        if (holes && count > 30) numbers[random.below(count)] = std::nanf("");
        samples = samples_of(size, numbers, SampleType::Float);
    } else {
        std::vector<std::int16_t> numbers;
        for (std::uint64_t i = 0; i < count; ++i)
            numbers.push_back(static_cast<std::int16_t>(number()));
        samples = samples_of(size, numbers, SampleType::Int16);
    }
    Geometry place;
    const double angle = random.one_in(3) ? random.uniform(0, 6.3) : 0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const std::array spacing{random.uniform(0.2, 2), random.uniform(0.2, 2),
                             random.uniform(0.2, 2)};
    place.world_from_index = {{{c * spacing[0], -s * spacing[1], 0},
                               {s * spacing[0], c * spacing[1], 0},
                               {0, 0, spacing[2]}}};
    for (double& x : place.origin)
        x = random.uniform(-9, 9);
    const auto outside = static_cast<Outside>(random.below(3));
    return volume_of(samples, place, {.outside = outside, .constant = 12}, random.below(3));
}

/// A box of any size about a place in the grid or at its border.
template <class Real>
struct WorldBox {
    std::array<Real, 3> lo, hi;

    WorldBox(const Volume& volume, RandomNumbers& random) {
        std::array<double, 3> index{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto end = static_cast<double>(volume.data().samples().size[i] - 1);
            index[i] = random.uniform(-0.2 * end, 1.2 * end);
            if (random.one_in(3)) index[i] = std::floor(index[i]);
        }
        const auto middle = world_point(volume.data().geometry(), index);
        const double all = std::exp2(random.uniform(-12, 4));
        for (std::size_t i = 0; i < 3; ++i) {
            const double half = random.one_in(4) ? 0 : all * random.uniform();
            lo[i] = static_cast<Real>(middle[i] - half);
            hi[i] = std::max(lo[i], static_cast<Real>(middle[i] + half));
        }
    }
    [[nodiscard]] std::array<double, 3> point(RandomNumbers& random) const {
        std::array<double, 3> at{};
        for (std::size_t i = 0; i < 3; ++i) {
            const double share = random.one_in(4) ? double(random.below(2)) : random.uniform();
            const double x =
                static_cast<double>(lo[i]) + share * static_cast<double>(hi[i] - lo[i]);
            at[i] = std::clamp(x, static_cast<double>(lo[i]), static_cast<double>(hi[i]));
        }
        return at;
    }
};

template <class Real>
class VolumeEnclosures : public ::testing::Test {
protected:
    using Ranges = std::array<Real, FieldRange::answers>;
    using Forms = std::array<Real, FieldForm::answers>;

    static Ranges range(const Field& field, const WorldBox<Real>& box, int derivative = 0) {
        const UpwardRounding upward;
        return answers(FieldRange(), field, derivative,
                       std::array<Real, 6>{-box.lo[0], -box.lo[1], -box.lo[2], box.hi[0], box.hi[1],
                                           box.hi[2]});
    }
    static Forms form(const Field& field, const WorldBox<Real>& box,
                      const std::array<Real, 3>& middle) {
        const UpwardRounding upward;
        return answers(FieldForm(), field, 0,
                       std::array<Real, 9>{-box.lo[0], -box.lo[1], -box.lo[2], box.hi[0], box.hi[1],
                                           box.hi[2], middle[0], middle[1], middle[2]});
    }
    static bool holds(const MpfrNumber& value, Real neg_lo, Real hi) {
        return mpfr_cmp_d(value.get(), -static_cast<double>(neg_lo)) >= 0 &&
               mpfr_cmp_d(value.get(), static_cast<double>(hi)) <= 0;
    }
};
TYPED_TEST_SUITE(VolumeEnclosures, RealTypes, RealTypeNames);

TYPED_TEST(VolumeEnclosures, HoldTheValuesInBoxes) {
    RandomNumbers random(31);
    int defined = 0;
    int proved = 0;
    for (int n = 0; n < 60; ++n) {
        const auto volume = random_volume(random);
        for (int b = 0; b < 60; ++b) {
            const WorldBox<TypeParam> box(*volume, random);
            const auto found = TestFixture::range(*volume, box);
            for (int i = 0; i < 6; ++i) {
                const auto at = box.point(random);
                const Reference truth = field_reference(*volume, MpfrNumber(at[0]),
                                                        MpfrNumber(at[1]), MpfrNumber(at[2]));
                if (!truth.defined) {
                    ASSERT_EQ(found[FieldRange::everywhere], 0) << "defined at a hole";
                    continue;
                }
                ++defined;
                ASSERT_EQ(found[FieldRange::somewhere], 1);
                ASSERT_TRUE(TestFixture::holds(truth.value, found[0], found[1]))
                    << truth.value.text() << " is not in [" << -found[0] << ", " << found[1] << "]";
            }
            if (found[FieldRange::everywhere] == 1) ++proved;
        }
    }
    EXPECT_GT(defined, 10'000);
    EXPECT_GT(proved, 1'000);
}

/// Whether a form tells what the plain range tells. Without FMA forms in double are answered one by
/// one where ranges are answered in vectors: both enclose, but not with the same bits.
template <class Real, std::size_t forms>
bool same_range(const std::array<Real, FieldRange::answers>& plain,
                const std::array<Real, forms>& form) {
    const bool alike = machine_has_fma() || std::is_same_v<Real, float>;
    const std::size_t from = alike ? FieldRange::range : FieldRange::somewhere;
    return std::equal(plain.begin() + from, plain.end(), form.begin() + from);
}

TYPED_TEST(VolumeEnclosures, HoldTheValueAtTheMiddleAndAllSlopesFromIt) {
    RandomNumbers random(32);
    int smooth = 0;
    for (int n = 0; n < 60; ++n) {
        const auto volume = random_volume(random);
        for (int b = 0; b < 60; ++b) {
            const WorldBox<TypeParam> box(*volume, random);
            std::array<TypeParam, 3> middle{};
            for (std::size_t i = 0; i < 3; ++i)
                middle[i] = box.lo[i] + (box.hi[i] - box.lo[i]) / 2;
            const auto found = TestFixture::form(*volume, box, middle);
            const auto plain = TestFixture::range(*volume, box);
            ASSERT_TRUE(same_range(plain, found));
            if (!std::isfinite(found[FieldForm::at_middle])) continue;
            ++smooth;
            const auto value = [&](const std::array<double, 3>& at) {
                return field_reference(*volume, MpfrNumber(at[0]), MpfrNumber(at[1]),
                                       MpfrNumber(at[2]));
            };
            const std::array<double, 3> from{static_cast<double>(middle[0]),
                                             static_cast<double>(middle[1]),
                                             static_cast<double>(middle[2])};
            const Reference centre = value(from);
            if (!centre.defined) continue;
            ASSERT_TRUE(TestFixture::holds(centre.value, found[FieldForm::at_middle],
                                           found[FieldForm::at_middle + 1]));
            const auto to = box.point(random);
            const Reference other = value(to);
            if (!other.defined) continue;
            ASSERT_TRUE(TestFixture::holds(other.value, found[FieldForm::range],
                                           found[FieldForm::range + 1]));
            // value(to) - value(from) in the sum of slopes times steps
            double lo = 0;
            double hi = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double step = to[i] - from[i];
                const double steepest = static_cast<double>(found[FieldForm::slopes + 2 * i + 1]);
                const double least = -static_cast<double>(found[FieldForm::slopes + 2 * i]);
                lo += std::min(step * steepest, step * least);
                hi += std::max(step * steepest, step * least);
            }
            const double rise = (other.value - centre.value).nearest();
            const double error = 1e-13 * (1 + std::abs(rise) + std::abs(lo) + std::abs(hi));
            ASSERT_GE(rise, lo - error);
            ASSERT_LE(rise, hi + error);
        }
    }
    EXPECT_GT(smooth, 700);
}

/// How far a value, asked for in this rounding mode, is from the true one; NaN where there is none
/// or where it may jump.
template <class Real>
double error_of_value(const Volume& volume, const std::array<Real, 3>& at, bool up) {
    std::array<Real, 4> value{};
    const auto ask = [&] { volume.values(0, at.data(), value.data(), 1); };
    if (up) {
        const UpwardRounding upward;
        ask();
    } else {
        ask();
    }
    const Reference truth = field_reference(volume, MpfrNumber(static_cast<double>(at[0])),
                                            MpfrNumber(static_cast<double>(at[1])),
                                            MpfrNumber(static_cast<double>(at[2])));
    if (!truth.defined || volume.options().outside == Outside::Constant)
        return std::numeric_limits<double>::quiet_NaN();
    return std::abs((truth.value - MpfrNumber(static_cast<double>(value[0]))).nearest());
}

/// The value that kernels take is off by at most what forms tell: r units of the type.
TYPED_TEST(VolumeEnclosures, BoundTheRoundingOfValues) {
    RandomNumbers random(33);
    double most = 0;
    for (int n = 0; n < 60; ++n) {
        const auto volume = random_volume(random);
        for (int b = 0; b < 40; ++b) {
            const WorldBox<TypeParam> box(*volume, random);
            const auto found = TestFixture::form(*volume, box, box.lo);
            std::array<TypeParam, 3> at{};
            for (std::size_t i = 0; i < 3; ++i)
                at[i] = random.one_in(2) ? box.lo[i] : box.hi[i];
            for (const bool up : {false, true}) {
                const double error = error_of_value(*volume, at, up);
                const double unit = std::numeric_limits<TypeParam>::epsilon();
                const double bound = unit * static_cast<double>(found[FieldForm::rounding]);
                if (std::isnan(error)) continue;
                ASSERT_LE(error, bound);
                if (bound > 0) most = std::max(most, error / bound);
            }
        }
    }
    EXPECT_GT(most, 0.05);  // the bound is not far off
}

TYPED_TEST(VolumeEnclosures, AreExactInOneCell) {
    const auto volume = linear_volume();
    RandomNumbers random(34);
    for (int i = 0; i < 200; ++i) {
        WorldBox<TypeParam> box(*volume, random);
        double lo = 0;
        double hi = 0;
        double per = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto cell = static_cast<TypeParam>(random.below(2));
            const TypeParam a = cell + static_cast<TypeParam>(random.uniform(0.01, 0.98));
            const TypeParam b = cell + static_cast<TypeParam>(random.uniform(0.01, 0.98));
            box.lo[axis] = std::min(a, b);
            box.hi[axis] = std::max(a, b);
            lo += per * static_cast<double>(box.lo[axis]);
            hi += per * static_cast<double>(box.hi[axis]);
            per *= 10;
        }
        const auto found = TestFixture::range(*volume, box);
        const double few = 128 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon());
        EXPECT_NEAR(-static_cast<double>(found[0]), lo, few * (hi + 100));
        EXPECT_NEAR(static_cast<double>(found[1]), hi, few * (hi + 100));
        EXPECT_EQ(found[FieldRange::everywhere], 1);
        const auto slope = TestFixture::range(*volume, box, derivative_by(0, 1, 0));
        EXPECT_NEAR(static_cast<double>(slope[1]), 10, 1e-3);
        EXPECT_NEAR(-static_cast<double>(slope[0]), 10, 1e-3);
    }
}

TYPED_TEST(VolumeEnclosures, HoldDerivativesOfFirstAndSecondOrder) {
    RandomNumbers random(35);
    int proved = 0;
    for (int n = 0; n < 60; ++n) {
        const auto volume = random_volume(random);
        for (int b = 0; b < 60; ++b) {
            const WorldBox<TypeParam> box(*volume, random);
            const auto at = box.point(random);
            for (const int derivative :
                 {derivative_by(1, 0, 0), derivative_by(0, 0, 1), derivative_by(1, 1, 0),
                  derivative_by(0, 1, 1), derivative_by(2, 0, 0)}) {
                const auto found = TestFixture::range(*volume, box, derivative);
                if (found[FieldRange::everywhere] != 1) continue;
                ++proved;
                const double value = value_at(*volume, at, derivative)[0];
                const double error = 1e-12 * (1 + std::abs(value));
                ASSERT_GE(value, -static_cast<double>(found[0]) - error);
                ASSERT_LE(value, static_cast<double>(found[1]) + error);
            }
        }
    }
    EXPECT_GT(proved, 500);
}

TEST(Volume, HasTheDerivativesOfDifferences) {
    RandomNumbers random(36);
    int compared = 0;
    for (int n = 0; n < 40; ++n) {
        const auto volume = random_volume(random);
        if (volume->options().outside == Outside::Constant) continue;
        for (int b = 0; b < 40; ++b) {
            const auto at = WorldBox<double>(*volume, random).point(random);
            constexpr double step = 1e-5;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                auto before = at;
                auto after = at;
                before[axis] -= step;
                after[axis] += step;
                const auto here = value_at(*volume, at);
                const auto below = value_at(*volume, before);
                const auto above = value_at(*volume, after);
                // One smooth piece only.
                const double bend = above[0] + below[0] - 2 * here[0];
                if (std::isnan(bend) || std::abs(bend) > 1e-7) continue;
                ++compared;
                EXPECT_NEAR(here[1 + axis], (above[0] - below[0]) / (2 * step), 2e-2);
                const int first = once_more_by(0, axis);
                EXPECT_EQ(value_at(*volume, at, first)[0], here[1 + axis]);
                const int second = once_more_by(first, (axis + 1) % 3);
                const double mixed = value_at(*volume, at, first)[1 + (axis + 1) % 3];
                EXPECT_EQ(value_at(*volume, at, second)[0], mixed);
            }
        }
    }
    EXPECT_GT(compared, 1000);
}

/// A box whose ends mean nothing gets an answer that holds all values, and nothing fails.
TYPED_TEST(VolumeEnclosures, TakeUnboundedAndUnknownBoxes) {
    const TypeParam inf = std::numeric_limits<TypeParam>::infinity();
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    const auto volume = linear_volume({.outside = Outside::Edge});
    for (const TypeParam end : {inf, nan, std::numeric_limits<TypeParam>::max()}) {
        const auto found = answers(FieldRange(), *volume, 0,
                                   std::array<TypeParam, 6>{end, end, end, end, end, end});
        EXPECT_LE(-found[0], 0);
        EXPECT_GE(found[1], 423);
        EXPECT_EQ(found[FieldRange::somewhere], 1);
    }
}

}  // namespace
}  // namespace zeroset::test::volume_enclosures_test
