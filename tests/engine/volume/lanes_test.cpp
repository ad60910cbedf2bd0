#include "engine/real/rounding.hpp"
#include "engine/volume/volume.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"
#include "tests/support/voxel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

// Questions in many lanes: they give the same as one by one, as the other tests of volumes ask; and
// they enclose. Inside, at borders, beyond, near holes, in boxes of all sizes.

namespace zeroset::test::lanes_test {
namespace {

template <class Real>
class VolumeLanesTest : public testing::Test {
protected:
    /// Some volumes: turned or not, with a hole or not, beyond its samples in all ways.
    static std::vector<std::shared_ptr<const Volume>> volumes() {
        std::vector<std::shared_ptr<const Volume>> all;
        for (int n = 0; n < 12; ++n) {
            RandomNumbers random(static_cast<std::uint64_t>(n) + 90);
            GridSize size{};
            for (auto& count : size)
                count = static_cast<std::uint64_t>(random.between(2, 20));
            Geometry place{.origin = {0.3, -2, 5}};
            if (n % 2 == 1)
                place.world_from_index = {{{0.8, -0.3, 0.1}, {0.3, 1.1, 0}, {0, 0.2, 0.5}}};
            const VolumeOptions options{.outside = static_cast<Outside>(n % 3), .constant = 0.25};
            all.push_back(volume_from(
                size, place,
                [&](double, double, double) {
                    return n % 4 == 3 && random.one_in(200)
                               ? std::numeric_limits<double>::quiet_NaN()
                               : random.uniform(-3, 7);
                },
                options));
        }
        return all;
    }
    /// A point about the volume, often in it, now and then on a sample.
    static std::array<double, 3> point_near(const Volume& volume, RandomNumbers& random) {
        std::array<double, 3> index{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto last = static_cast<double>(volume.data().samples().size[i] - 1);
            index[i] = random.one_in(12) ? random.uniform(-2, last + 2) : random.uniform(0, last);
            if (random.one_in(8)) index[i] = std::round(index[i]);
        }
        return world_point(volume.data().geometry(), index);
    }
    /// Asks in `lanes` lanes and in one; calls check(lane's answers, single answers).
    template <class Question, class Check>
    static void compare(const Volume& volume, const std::vector<Real>& in, int lanes,
                        const Check& check) {
        const auto count = static_cast<std::size_t>(lanes);
        std::vector<Real> out(Question::answers * count);
        ask<Question, Real>(volume, 0, in.data(), out.data(), lanes);
        for (std::size_t lane = 0; lane < count; ++lane) {
            std::array<Real, Question::questions> one{};
            for (std::size_t i = 0; i < one.size(); ++i)
                one[i] = in[i * count + lane];
            std::array<Real, Question::answers> alone{};
            ask<Question, Real>(volume, 0, one.data(), alone.data(), 1);
            std::array<Real, Question::answers> among{};
            for (std::size_t i = 0; i < among.size(); ++i)
                among[i] = out[i * count + lane];
            check(among, alone);
        }
    }
    /// Equal to the last bit, or not known.
    static void expect_same(const auto& among, const auto& alone) {
        for (std::size_t i = 0; i < alone.size(); ++i) {
            EXPECT_TRUE(among[i] == alone[i] || (std::isnan(among[i]) && std::isnan(alone[i])))
                << "column " << i << ": " << among[i] << ", alone " << alone[i];
        }
    }
};

TYPED_TEST_SUITE(VolumeLanesTest, RealTypes, RealTypeNames);

TYPED_TEST(VolumeLanesTest, GiveTheSameValues) {
    using Real = TypeParam;
    for (const auto& volume : this->volumes()) {
        RandomNumbers random(4);
        for (const int lanes : {2, 4, 8, 16, 32, 48}) {
            const auto count = static_cast<std::size_t>(lanes);
            std::vector<Real> in(3 * count);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const auto point = this->point_near(*volume, random);
                for (std::size_t i = 0; i < 3; ++i)
                    in[i * count + lane] = static_cast<Real>(point[i]);
            }
            this->template compare<FieldValue>(
                *volume, in, lanes,
                [](const auto& a, const auto& b) { TestFixture::expect_same(a, b); });
        }
    }
}

/// Boxes about the volume from a point in a cell to the whole of it, and a point in each.
template <class Real>
std::vector<Real> random_boxes(std::size_t count, RandomNumbers& random, const auto& point_near) {
    std::vector<Real> in(9 * count);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const auto middle = point_near();
        const double size = std::exp2(random.uniform(-12, 4));
        for (std::size_t i = 0; i < 3; ++i) {
            const double half = random.one_in(20) ? 0 : size * random.uniform(0, 1);
            const auto at = static_cast<Real>(middle[i]);
            in[i * count + lane] = -static_cast<Real>(static_cast<double>(at) - half);
            in[(3 + i) * count + lane] = static_cast<Real>(static_cast<double>(at) + half);
            in[(6 + i) * count + lane] = at;
        }
    }
    return in;
}

TYPED_TEST(VolumeLanesTest, GiveTheSameForms) {
    using Real = TypeParam;
    const UpwardRounding upward;
    for (const auto& volume : this->volumes()) {
        RandomNumbers random(6);
        for (const int lanes : {4, 16, 48}) {
            const auto in = random_boxes<Real>(static_cast<std::size_t>(lanes), random,
                                               [&] { return this->point_near(*volume, random); });
            this->template compare<FieldForm>(*volume, in, lanes, [](const auto& a, const auto& b) {
                TestFixture::expect_same(a, b);
            });
            const std::vector<Real> boxes(in.begin(), in.begin() + 6 * lanes);
            this->template compare<FieldRange>(
                *volume, boxes, lanes,
                [](const auto& a, const auto& b) { TestFixture::expect_same(a, b); });
        }
    }
}

TYPED_TEST(VolumeLanesTest, EncloseTheValuesInTheirBoxes) {
    using Real = TypeParam;
    const UpwardRounding upward;
    std::size_t tight = 0;
    for (const auto& volume : this->volumes()) {
        RandomNumbers random(8);
        constexpr std::size_t lanes = 16;
        for (int n = 0; n < 40; ++n) {
            const auto in = random_boxes<Real>(lanes, random,
                                               [&] { return this->point_near(*volume, random); });
            std::vector<Real> out(FieldForm::answers * lanes);
            ask<FieldForm, Real>(*volume, 0, in.data(), out.data(), static_cast<int>(lanes));
            std::vector<Real> ranges(FieldRange::answers * lanes);
            ask<FieldRange, Real>(*volume, 0, in.data(), ranges.data(), static_cast<int>(lanes));
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const auto column = [&](std::size_t i) {
                    return static_cast<double>(out[i * lanes + lane]);
                };
                std::array<double, 3> point{};
                for (std::size_t i = 0; i < 3; ++i) {
                    const auto lo = -static_cast<double>(in[i * lanes + lane]);
                    const auto hi = static_cast<double>(in[(3 + i) * lanes + lane]);
                    point[i] = std::min(std::max(random.uniform(lo, hi), lo), hi);
                }
                std::array<double, 4> value{};
                volume->values(0, point.data(), value.data(), 1);
                if (std::isnan(value[0])) continue;
                EXPECT_GE(column(FieldForm::range), -value[0]);
                EXPECT_GE(column(FieldForm::range + 1), value[0]);
                EXPECT_GE(static_cast<double>(ranges[lane]), -value[0]);
                EXPECT_GE(static_cast<double>(ranges[lanes + lane]), value[0]);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    EXPECT_GE(column(FieldForm::slopes + 2 * axis), -value[1 + axis] - 1e-12);
                    EXPECT_GE(column(FieldForm::slopes + 2 * axis + 1), value[1 + axis] - 1e-12);
                }
                tight += column(FieldForm::range) + column(FieldForm::range + 1) < 0.5 ? 1U : 0U;
            }
        }
    }
    EXPECT_GT(tight, 500U);
}

}  // namespace
}  // namespace zeroset::test::lanes_test
