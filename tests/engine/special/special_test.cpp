#include "engine/special/special.hpp"

#include "engine/real/rounding.hpp"
#include "engine/special/line_field.hpp"
#include "tests/support/field_checks.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"
#include "tests/support/special_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

// Special functions against references in 256 bits: values, derivatives, enclosures.

namespace zeroset::test::special_test {
namespace {

struct Sampled {
    SpecialFunction function;
    int order;
    double from, to;  ///< where it is looked at

    [[nodiscard]] std::shared_ptr<const LineField> field() const {
        return std::dynamic_pointer_cast<const LineField>(special_field(function, order));
    }
    [[nodiscard]] bool is_right_only() const { return !field()->is_total(); }
    [[nodiscard]] MpfrNumber exact(const MpfrNumber& x) const {
        return special_reference(function, order, x).value;
    }
};

std::vector<Sampled> all_sampled() {
    using enum SpecialFunction;
    return {{Erf, 0, -7, 7},          {Erfc, 0, -4, 9},       {ReciprocalGamma, 0, -12, 20},
            {LogGamma, 0, 0, 40},     {Digamma, 0, 0, 40},    {ZetaTimes, 0, -9, 12},
            {LambertOfRoot, 0, 0, 9}, {BesselJ, 0, -40, 40},  {BesselJ, 1, -40, 40},
            {BesselJ, 7, -40, 40},    {BesselJ, 60, -90, 90}, {BesselY, 0, 0, 20},
            {BesselY, 3, 0, 20},      {BesselI, 0, -9, 9},    {BesselI, 5, -9, 9},
            {BesselK, 0, 0, 9},       {BesselK, 4, 0, 9},     {BesselJ, 2, 4000, 4090},
            {BesselY, 8, 1, 90},      {BesselK, 8, 1, 90}};
}

double some_place(const Sampled& of, RandomNumbers& random) {
    const double x = random.uniform(of.from, of.to);
    if (of.from == 0 && random.one_in(3)) return x * std::exp2(random.uniform(-12, 0));
    return x;
}

/// A short or long box about a place, in which there is one.
template <class Real>
std::array<Real, 9> some_box(const Sampled& of, RandomNumbers& random) {
    const double x = some_place(of, random);
    const double size = (of.to - of.from) * std::exp2(random.uniform(-24, -1));
    double lo = x - (random.one_in(4) ? 0 : size * random.uniform());
    if (of.function == SpecialFunction::LambertOfRoot) lo = std::max(lo, 0.0);
    const auto middle = static_cast<Real>(x);
    const auto hi = static_cast<Real>(x + (random.one_in(4) ? 0 : size * random.uniform()));
    return {
        -std::min(static_cast<Real>(lo), middle), 0, 0, std::max(hi, middle), 0, 0, middle, 0, 0};
}

MpfrNumber slope(const Sampled& of, const MpfrNumber& x) {
    const MpfrNumber step(0x1p-60);
    return (of.exact(x + step) - of.exact(x - step)) / (step + step);
}
MpfrNumber bend(const Sampled& of, const MpfrNumber& x) {
    const MpfrNumber step(0x1p-50);
    return (slope(of, x + step) - slope(of, x - step)) / (step + step);
}

TEST(Special, ValuesAndDerivativesAreThoseOfReferences) {
    RandomNumbers random(52);
    for (const Sampled& of : all_sampled()) {
        const auto field = of.field();
        for (int n = 0; n < 6; ++n) {
            const double x = some_place(of, random);
            const MpfrNumber at(x);
            const double first = slope(of, at).nearest();
            const double second = bend(of, at).nearest();
            const auto value = value_at(*field, {x, 0, 0});
            const double size = 1 + std::abs(value[0]) + std::abs(first) + std::abs(second);
            EXPECT_NEAR(value[0], of.exact(at).nearest(), 2e-15 * size) << field->text() << x;
            EXPECT_NEAR(value[1], first, 1e-13 * size) << field->text() << x;
            EXPECT_EQ(value[2], 0);
            EXPECT_EQ(value[3], 0);
            const auto of_slope = value_at(*field, {x, 0, 0}, derivative_by(1, 0, 0));
            EXPECT_NEAR(of_slope[1], second, 1e-12 * size) << field->text() << x;
            // The derivative's own field tells the same.
            const auto derived = value_at(*field->derivative(), {x, 0, 0});
            EXPECT_EQ(derived[0], of_slope[0]);
            EXPECT_EQ(derived[1], of_slope[1]);
            EXPECT_EQ(value_at(*field, {x, 0, 0}, derivative_by(0, 1, 0))[0], 0);
        }
    }
}

template <class Real>
class SpecialOver : public ::testing::Test {};
TYPED_TEST_SUITE(SpecialOver, RealTypes);

template <class Real>
void expect_inside(const Real* ends, const MpfrNumber& x, const std::string& what) {
    EXPECT_FALSE(x < -static_cast<double>(ends[0])) << what << x.text();
    EXPECT_FALSE(x > static_cast<double>(ends[1])) << what << x.text();
}

TYPED_TEST(SpecialOver, BoxesHoldReferences) {
    using Real = TypeParam;
    RandomNumbers random(1904);
    for (const Sampled& of : all_sampled()) {
        const auto field = of.field();
        for (int n = 0; n < 24; ++n) {
            const auto box = some_box<Real>(of, random);
            std::array<Real, FieldForm::answers> form{};
            {
                const UpwardRounding upward;
                field->forms(box.data(), form.data(), 1);
            }
            const auto lo = -static_cast<double>(box[0]);
            const auto hi = static_cast<double>(box[3]);
            const double x = random.one_in(5) ? hi : random.uniform(lo, hi);
            if (of.is_right_only() && x <= 1e-6) continue;
            const MpfrNumber at(x);
            expect_inside(&form[FieldForm::range], of.exact(at), field->text());
            expect_inside(&form[FieldForm::at_middle],
                          of.exact(MpfrNumber(static_cast<double>(box[6]))), field->text());
            const auto slope_at = MpfrNumber(slope(of, at).nearest());
            const double near = 1e-12 * (1 + std::abs(slope_at.nearest()));
            EXPECT_GE(static_cast<double>(form[FieldForm::slopes]), -slope_at.nearest() - near);
            EXPECT_GE(static_cast<double>(form[FieldForm::slopes + 1]), slope_at.nearest() - near);
        }
    }
}

/// Ranges of derivatives hold the derivatives at points.
TYPED_TEST(SpecialOver, BoxesHoldDerivatives) {
    using Real = TypeParam;
    RandomNumbers random(7);
    for (const Sampled& of : all_sampled()) {
        const auto plain = of.field();
        for (const auto& field : {plain, plain->derivative(), plain->derivative()->derivative()}) {
            for (int n = 0; n < 100; ++n) {
                const auto box = some_box<Real>(of, random);
                const std::array<Real, 6> in{box[0], 0, 0, box[3], 0, 0};
                const int derivative = derivative_by(random.between(0, 2), 0, 0);
                std::array<Real, FieldRange::answers> range{};
                {
                    const UpwardRounding upward;
                    field->ranges(derivative, in.data(), range.data(), 1);
                }
                const double x =
                    random.uniform(-static_cast<double>(box[0]), static_cast<double>(box[3]));
                const double value = value_at(*field, {x, 0, 0}, derivative)[0];
                if (std::isnan(value)) continue;
                const double near = 1e-11 * (1 + std::abs(value));
                EXPECT_GE(static_cast<double>(range[0]), -value - near) << field->text() << x;
                EXPECT_GE(static_cast<double>(range[1]), value - near) << field->text() << x;
            }
        }
    }
}

TYPED_TEST(SpecialOver, LanesAreAnsweredAsAlone) {
    RandomNumbers random(11);
    for (const Sampled& of : all_sampled())
        expect_lanes_alike<TypeParam>(*of.field(), [&] { return some_box<TypeParam>(of, random); });
}

ValueBounds range_of(const Field& field, double lo, double hi, int times = 0) {
    const std::array<double, 6> box{-lo, 0, 0, hi, 0, 0};
    std::array<double, FieldRange::answers> range{};
    const UpwardRounding upward;
    field.ranges(derivative_by(times, 0, 0), box.data(), range.data(), 1);
    return {.lo = -range[0], .hi = range[1]};
}

void expect_bounds(const ValueBounds& found, double lo, double hi) {
    EXPECT_NEAR(found.lo, lo, 1e-12);
    EXPECT_NEAR(found.hi, hi, 1e-12);
}

/// Ranges are tight where functions turn: known extremes.
TEST(Special, RangesEndAtExtremes) {
    const auto j0 = special_field(SpecialFunction::BesselJ, 0);
    expect_bounds(range_of(*j0, -5, 7), -0.40275939570255, 1);
    expect_bounds(range_of(*j0, 2, 9), -0.40275939570255, 0.30011575252613);
    expect_bounds(range_of(*j0, -1, 1, 1), -0.44005058574493, 0.44005058574493);
    expect_bounds(range_of(*special_field(SpecialFunction::LogGamma), 1, 3), -0.12148629053585,
                  std::log(2.0));
    expect_bounds(range_of(*special_field(SpecialFunction::ReciprocalGamma), -1, 2),
                  1 / -3.54464361115501, 1 / 0.88560319441089);
    expect_bounds(range_of(*special_field(SpecialFunction::Erf), -1, 2), -std::erf(1.0),
                  std::erf(2.0));
    expect_bounds(range_of(*special_field(SpecialFunction::LambertOfRoot), 0, 1), -1, 0);
}

TEST(Special, KnowWhatIsFarAway) {
    const double far = 1e9;
    EXPECT_NEAR(value_at(*special_field(SpecialFunction::Erf), {far, 0, 0})[0], 1, 1e-15);
    EXPECT_NEAR(value_at(*special_field(SpecialFunction::Erf), {-far, 0, 0})[0], -1, 1e-15);
    EXPECT_NEAR(value_at(*special_field(SpecialFunction::ReciprocalGamma), {far, 0, 0})[0], 0,
                1e-250);
    const auto j3 = special_field(SpecialFunction::BesselJ, 3);
    EXPECT_TRUE(std::isnan(value_at(*j3, {far, 0, 0})[0]));
    const ValueBounds bounds = range_of(*j3, far, 2 * far);
    EXPECT_TRUE(bounds.lo > -0.013 && bounds.lo < 0 && bounds.hi > 0 && bounds.hi < 0.013);
    const double infinite = std::numeric_limits<double>::infinity();
    for (const Sampled& of : all_sampled()) {
        const ValueBounds all = range_of(*of.field(), -infinite, infinite);
        const double value = value_at(*of.field(), {1.5, 0, 0})[0];
        EXPECT_TRUE(all.lo <= value && value <= all.hi) << of.field()->text();
    }
    expect_bounds(range_of(*j3, -infinite, infinite), -1, 1);
}

/// Some functions are defined right of 0 only, and tend to an infinity there.
TEST(Special, DomainsAreTold) {
    for (const Sampled& of : all_sampled()) {
        const auto field = of.field();
        const auto masks = [&](double lo, double hi) {
            const std::array<double, 6> box{-lo, 0, 0, hi, 0, 0};
            std::array<double, FieldRange::answers> range{};
            field->ranges(0, box.data(), range.data(), 1);
            return std::array{range[FieldRange::somewhere], range[FieldRange::everywhere]};
        };
        const bool total = field->is_total();
        EXPECT_EQ(masks(1, 2), (std::array{1.0, 1.0}));
        EXPECT_EQ(masks(-1, 2), (std::array{1.0, total ? 1.0 : 0.0})) << field->text();
        EXPECT_EQ(masks(-2, 0), (std::array{total ? 1.0 : 0.0, total ? 1.0 : 0.0}));
        if (total) continue;
        EXPECT_TRUE(std::isnan(value_at(*field, {0, 0, 0})[0]));
        EXPECT_TRUE(std::isnan(value_at(*field, {-1, 0, 0})[0]));
        const ValueBounds range = range_of(*field, 0, 0.5);
        const bool up = value_at(*field, {0.25, 0, 0})[0] > value_at(*field, {0.5, 0, 0})[0];
        const double end = value_at(*field, {0.5, 0, 0})[0];
        EXPECT_NEAR(up ? range.lo : range.hi, end, 1e-12 * (1 + std::abs(end))) << field->text();
        EXPECT_TRUE(std::isinf(up ? range.hi : range.lo)) << field->text();
    }
}

}  // namespace
}  // namespace zeroset::test::special_test
