#include "engine/noise/noise.hpp"

#include "engine/noise/cellular.hpp"
#include "engine/noise/lattice_noise.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/field_checks.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/noise_reference.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

// Noise against its documentation in 256 bits: values, exact derivatives, enclosures.

namespace zeroset::test::noise_test {
namespace {

std::vector<std::shared_ptr<const Field>> all_noise() {
    std::vector<std::shared_ptr<const Field>> all;
    for (const NoiseWord word :
         {NoiseWord::Noise, NoiseWord::ValueNoise, NoiseWord::Cellular, NoiseWord::Cellular2}) {
        for (const std::uint32_t seed : {0U, 1U, 123456789U})
            all.push_back(noise_field(word, seed));
    }
    return all;
}

bool is_cellular(const Field& field) { return field.text().starts_with("cellular"); }

/// A point in cells near and far, on both sides of 0, often on or beside the walls between cells.
Point some_point(RandomNumbers& random) {
    constexpr std::array<double, 4> reach{2, 20, 1e6, 5e9};
    Point point{};
    for (double& x : point) {
        const double far = reach[random.below(reach.size())];
        x = random.uniform(-far, far);
        if (random.one_in(6)) x = std::round(x);
        if (random.one_in(12)) x = std::nextafter(std::round(x), random.one_in(2) ? -1e99 : 1e99);
    }
    return point;
}

TEST(Noise, IsTheSameOnEveryMachine) {
    EXPECT_EQ(mixed_bits(0), 0U);
    EXPECT_EQ(mixed_bits(1), 0x688990C0U);
    for (const std::int64_t i : {0L, 1L, -1L, 77L, -4294967297L}) {
        std::uint32_t hash = hash_of_seed(5);
        for (const std::int64_t coordinate : {i, std::int64_t{2}, std::int64_t{-3}})
            hash = with_coordinate(hash, lattice_coordinate(static_cast<double>(coordinate)));
        EXPECT_EQ(hash, reference_hash(5, i, 2, -3));
    }
    // Found with Python's fractions, from the documentation alone.
    EXPECT_EQ(value_at(*noise_field(NoiseWord::Noise, 0), {0.5, 0.25, 0.75})[0], 0x1.c5838p-4);
    EXPECT_EQ(value_at(*noise_field(NoiseWord::Noise, 9), {-3.5, 2.5, 0.5})[0], 0.5);
    EXPECT_EQ(value_at(*noise_field(NoiseWord::ValueNoise, 0), {0.5, 0.5, 1})[0], 0x1.c559b8p-4);
    EXPECT_EQ(value_at(*noise_field(NoiseWord::ValueNoise, 3), {7, -2, 5})[0], -0x1.953c28p-1);
    EXPECT_NEAR(value_at(*noise_field(NoiseWord::Cellular, 0), {0.5, 0.25, 0.75})[0],
                0.45242480920400996, 1e-15);
    EXPECT_NEAR(value_at(*noise_field(NoiseWord::Cellular2, 0), {0.5, 0.25, 0.75})[0],
                0.6881321660555365, 1e-15);
}

TEST(Noise, HasTheDocumentedValues) {
    for (const auto& field : all_noise()) {
        RandomNumbers random(11);
        for (int n = 0; n < 150; ++n) {
            const Point point = some_point(random);
            const MpfrNumber error =
                MpfrNumber(value_at(*field, point)[0]) - exact(*field, wide(point));
            EXPECT_LT(std::abs(error.nearest()), noise_error / 4) << field->text();
        }
    }
}

TEST(Noise, HasExactDerivatives) {
    for (const auto& field : all_noise()) {
        RandomNumbers random(12);
        for (int n = 0; n < (is_cellular(*field) ? 8 : 40); ++n) {
            Point point{};
            for (double& x : point)
                x = random.uniform(-9, 9);
            expect_exact_derivatives(*field, point);
        }
    }
}

/// An upper bound of what the twelve directions can make of a sum over the corners of a cell, by
/// subdivision: `terms(box, corner, direction)` encloses a corner's part.
template <class Terms>
double greatest_sum(const Terms& terms, double enough) {
    struct Part {
        std::array<Interval<double>, 3> box;
        int depth;
    };
    const Interval<double> half{0, 0.5};  // the other halves mirror it
    std::vector<Part> open{{{half, half, half}, 0}};
    double greatest = 0;
    while (!open.empty()) {
        const Part part = open.back();
        open.pop_back();
        double sum = 0;
        for (unsigned corner = 0; corner < 8; ++corner) {
            double most = -1e9;
            for (unsigned direction = 0; direction < 12; ++direction)
                most = std::max(most, terms(part.box, corner, direction).hi);
            sum += most;
        }
        if (sum <= enough || part.depth == 30) {
            greatest = std::max(greatest, sum);
            continue;
        }
        const auto axis = static_cast<std::size_t>(part.depth % 3);
        const double middle = (part.box[axis].hi - part.box[axis].neg_lo) / 2;
        for (const bool upper : {false, true}) {
            Part child = part;
            (upper ? child.box[axis].neg_lo : child.box[axis].hi) = upper ? -middle : middle;
            ++child.depth;
            open.push_back(child);
        }
    }
    return greatest;
}

/// s, s' or s'' of [a, b], from the monotone pieces of each.
Interval<double> fade_over(const Interval<double>& t, int order) {
    const auto at = [&](double x) {
        if (order == 0) return x * x * x * (x * (6 * x - 15) + 10);
        return order == 1 ? 30 * x * x * (1 - x) * (1 - x) : 60 * x * (1 - x) * (1 - 2 * x);
    };
    const double a = -t.neg_lo;
    const double b = t.hi;
    double lo = std::min(at(a), at(b));
    double hi = std::max(at(a), at(b));
    const double turn = (3 - std::sqrt(3.0)) / 6;
    if (order == 1 && a <= 0.5 && b >= 0.5) hi = 1.875;
    if (order == 2 && a <= turn && b >= turn) hi = 10 / std::sqrt(3.0);
    if (order == 2 && a <= 1 - turn && b >= 1 - turn) lo = -10 / std::sqrt(3.0);
    return {1e-14 - lo, hi + 1e-14};
}

TEST(GradientNoise, IsProvedToKeepItsBounds) {
    const UpwardRounding upward;
    constexpr std::array<std::array<int, 3>, 12> directions{{{1, 1, 0},
                                                             {-1, 1, 0},
                                                             {1, -1, 0},
                                                             {-1, -1, 0},
                                                             {1, 0, 1},
                                                             {-1, 0, 1},
                                                             {1, 0, -1},
                                                             {-1, 0, -1},
                                                             {0, 1, 1},
                                                             {0, -1, 1},
                                                             {0, 1, -1},
                                                             {0, -1, -1}}};
    /// The part of a corner in the derivative of noise of these orders.
    const auto bound = [&](const std::array<int, 3>& orders, double enough) {
        return greatest_sum(
            [&](const std::array<Interval<double>, 3>& box, unsigned corner, unsigned direction) {
                const auto& g = directions[direction];
                Interval<double> line{0, 0};
                for (std::size_t i = 0; i < 3; ++i) {
                    const double at = (corner >> i & 1U) != 0 ? 1 : 0;
                    const double lo = -box[i].neg_lo - at;
                    const double hi = box[i].hi - at;
                    line.neg_lo += g[i] == 0 ? 0 : g[i] > 0 ? -lo : hi;
                    line.hi += g[i] == 0 ? 0 : g[i] > 0 ? hi : -lo;
                }
                const auto weight = [&](const std::array<int, 3>& of) {
                    Interval<double> product{-1, 1};
                    for (std::size_t i = 0; i < 3; ++i) {
                        Interval<double> s = fade_over(box[i], of[i]);
                        if ((corner >> i & 1U) == 0) {
                            s = of[i] == 0 ? Interval<double>{s.hi - 1, 1 + s.neg_lo}
                                           : Interval<double>{s.hi, s.neg_lo};
                        }
                        product = product * s;
                    }
                    return product;
                };
                Interval<double> sum = weight(orders) * line;
                for (std::size_t i = 0; i < 3; ++i) {
                    if (orders[i] == 0) continue;
                    std::array<int, 3> less = orders;
                    --less[i];
                    const double factor = orders[i] * g[i];
                    sum = sum + weight(less) * Interval<double>{-factor, factor};
                }
                return sum;
            },
            enough);
    };
    const NoiseBounds bounds = noise_bounds(NoiseKind::Gradient);
    EXPECT_LE(bound({0, 0, 0}, bounds.value), bounds.value);
    EXPECT_LE(bound({1, 0, 0}, bounds.slope), bounds.slope);
    EXPECT_LE(bound({2, 0, 0}, bounds.own_bend), bounds.own_bend);
    EXPECT_LE(bound({1, 1, 0}, bounds.mixed_bend), bounds.mixed_bend);
}

template <class Real>
class NoiseEnclosure : public testing::Test {};
TYPED_TEST_SUITE(NoiseEnclosure, RealTypes, RealTypeNames);

TYPED_TEST(NoiseEnclosure, HoldsOfValuesAndDerivatives) {
    using Real = TypeParam;
    for (const auto& field : all_noise()) {
        RandomNumbers random(13);
        const EnclosureCheck check{.boxes = 3000,
                                   .every = is_cellular(*field) ? 100 : 20,
                                   .value_error = noise_error,
                                   .slope_error = noise_slope_error};
        const auto box = [&] { return box_about<Real>(some_point(random), {-20, 3}, random); };
        EXPECT_GT(expect_enclosures<Real>(*field, check, box, random), 1500) << field->text();
    }
}

TYPED_TEST(NoiseEnclosure, AnswersEachLaneAlikeAmongOthers) {
    using Real = TypeParam;
    for (const auto& field : all_noise()) {
        RandomNumbers random(15);
        expect_lanes_alike<Real>(
            *field, [&] { return box_about<Real>(some_point(random), {-20, 3}, random); });
    }
}

TYPED_TEST(NoiseEnclosure, OfTinyBoxesIsTight) {
    using Real = TypeParam;
    const UpwardRounding upward;
    RandomNumbers random(14);
    const auto field = noise_field(NoiseWord::Noise, 2);
    for (int n = 0; n < 500; ++n) {
        std::array<Real, 6> box{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = static_cast<Real>(random.uniform(-4, 4));
            box[i] = -at;
            box[3 + i] = at + Real(0x1p-10);
        }
        std::array<Real, FieldRange::answers> range{};
        field->ranges(0, box.data(), range.data(), 1);
        EXPECT_LT(range[0] + range[1], Real(12 * 0x1p-10));
    }
}

TEST(NoiseEnclosureOfOddBoxes, IsTheWholeRange) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& field : all_noise()) {
        for (const auto& [neg_lo, hi] :
             {std::array{infinity, infinity}, {nan, 1.0}, {0.0, nan}, {1e18, 1e18}, {0.0, 1e300}}) {
            const std::array box{neg_lo, 0.0, 0.0, hi, 0.5, 0.5};
            std::array<double, FieldRange::answers> range{};
            field->ranges(0, box.data(), range.data(), 1);
            EXPECT_GT(range[1], 0.99) << field->text();
            EXPECT_LT(range[1], 1.8) << field->text();
            EXPECT_GE(range[0], -0.1) << field->text();
        }
        EXPECT_TRUE(std::isnan(value_at(*field, {infinity, 0, 0})[0]));
        EXPECT_TRUE(std::isnan(value_at(*field, {0, nan, 0})[0]));
        EXPECT_TRUE(std::isfinite(value_at(*field, {1e300, -1e300, 0.5})[0]));
    }
}

TEST(Noise, RepeatsAfter2To32Cells) {
    for (const auto& field : all_noise()) {
        const double here = value_at(*field, {0.5, -1.25, 2.125})[0];
        EXPECT_EQ(value_at(*field, {0.5 + 0x1p32, -1.25 - 0x1p33, 2.125})[0], here);
        EXPECT_NE(value_at(*field, {0.5 + 0x1p31, -1.25, 2.125})[0], here);
    }
}

TEST(Noise, IsOneObjectForEachSeed) {
    EXPECT_EQ(noise_field(NoiseWord::Noise, 3), noise_field(NoiseWord::Noise, 3));
    EXPECT_NE(noise_field(NoiseWord::Noise, 3), noise_field(NoiseWord::Noise, 4));
    EXPECT_EQ(noise_field(NoiseWord::Noise, 0)->text(), "noise");
    EXPECT_EQ(noise_field(NoiseWord::Cellular2, 12)->text(), "cellular2, 12");
}

}  // namespace
}  // namespace zeroset::test::noise_test
