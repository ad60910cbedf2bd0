#pragma once

#include "engine/real/field.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/sample_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// Checks of what a field tells against its reference in 256 bits (field_reference).

namespace zeroset::test {

using Point = std::array<double, 3>;

inline MpfrNumber exact(const zeroset::Field& field, const std::array<MpfrNumber, 3>& at) {
    return field_reference(field, at[0], at[1], at[2]).value;
}
inline std::array<MpfrNumber, 3> wide(const Point& point) {
    return {MpfrNumber(point[0]), MpfrNumber(point[1]), MpfrNumber(point[2])};
}

/// A derivative along an axis, off by some 1e-24.
template <class Of>
MpfrNumber difference(const Of& of, std::array<MpfrNumber, 3> at, std::size_t axis) {
    const MpfrNumber step(0x1p-80);
    std::array<MpfrNumber, 3> before = at;
    at[axis] = at[axis] + step;
    before[axis] = before[axis] - step;
    return (of(at) - of(before)) / (step + step);
}

inline std::array<double, 4> value_at(const zeroset::Field& field, const Point& point,
                                      int derivative = 0) {
    std::array<double, 4> out{};
    field.values(derivative, point.data(), out.data(), 1);
    return out;
}

/// Compares first and second derivatives at a point with differences of the reference.
inline void expect_exact_derivatives(const zeroset::Field& field, const Point& point) {
    const auto value = value_at(field, point);
    for (std::size_t a = 0; a < 3; ++a) {
        const auto of = [&](const auto& at) { return exact(field, at); };
        const double slope = difference(of, wide(point), a).nearest();
        EXPECT_NEAR(value[1 + a], slope, 1e-12 * (1 + std::abs(slope))) << field.text();
        const auto first = value_at(field, point, once_more_by(0, a));
        EXPECT_EQ(first[0], value[1 + a]);
        for (std::size_t b = 0; b < 3; ++b) {
            const auto by = [&](const auto& at) { return difference(of, at, a); };
            const double bend = difference(by, wide(point), b).nearest();
            EXPECT_NEAR(first[1 + b], bend, 1e-9 * (1 + std::abs(bend))) << field.text();
            const auto second = value_at(field, point, once_more_by(once_more_by(0, a), b));
            EXPECT_EQ(second[0], first[1 + b]);
        }
    }
}

/// A box about a point, its edges 2^sizes long, not equally; then the point.
template <class Real>
std::array<Real, 9> box_about(const Point& point, const std::array<double, 2>& sizes,
                              RandomNumbers& random) {
    const double size = std::exp2(random.uniform(sizes[0], sizes[1]));
    std::array<Real, 9> box{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Real>(point[i]);
        const double before = random.one_in(5) ? 0 : size * random.uniform();
        const double behind = random.one_in(5) ? 0 : size * random.uniform();
        box[i] = -static_cast<Real>(static_cast<double>(at) - before);
        box[3 + i] = static_cast<Real>(static_cast<double>(at) + behind);
        box[6 + i] = at;
    }
    return box;
}

struct EnclosureCheck {
    int boxes;
    int every;                        ///< every so many are compared with the reference itself
    double value_error, slope_error;  ///< of values in double, with which the others are compared
};

/// Checks forms and ranges over boxes that `some_box` makes, at random points of them. Returns how
/// many ranges are shorter than 1/2.
template <class Real>
int expect_enclosures(const zeroset::Field& field, const EnclosureCheck& check,
                      const auto& some_box, RandomNumbers& random) {
    int tight = 0;
    const auto expect_in = [&](const Real* ends, double x, double error) {
        EXPECT_GE(static_cast<double>(ends[0]), -x - error) << field.text();
        EXPECT_GE(static_cast<double>(ends[1]), x - error) << field.text();
    };
    for (int n = 0; n < check.boxes; ++n) {
        const std::array<Real, 9> box = some_box();
        Point point{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto lo = -static_cast<double>(box[i]);
            const auto hi = static_cast<double>(box[3 + i]);
            point[i] = std::clamp(random.uniform(lo, hi), lo, hi);
        }
        std::array<Real, FieldForm::answers> form{};
        {
            const UpwardRounding upward;
            field.forms(box.data(), form.data(), 1);
        }
        if (n % check.every == 0) {
            const Point middle{static_cast<double>(box[6]), static_cast<double>(box[7]),
                               static_cast<double>(box[8])};
            expect_in(&form[FieldForm::range], exact(field, wide(point)).nearest(), 0);
            expect_in(&form[FieldForm::at_middle], exact(field, wide(middle)).nearest(), 0);
        }
        const auto value = value_at(field, point);
        expect_in(&form[FieldForm::range], value[0], check.value_error);
        for (std::size_t i = 0; i < 3; ++i)
            expect_in(&form[FieldForm::slopes + 2 * i], value[1 + i], check.slope_error);
        tight += form[FieldForm::range] + form[FieldForm::range + 1] < Real(0.5) ? 1 : 0;
        for (const auto& [x, y, z] : {std::array{1, 0, 0},
                                      {0, 1, 0},
                                      {0, 0, 1},
                                      {2, 0, 0},
                                      {0, 2, 0},
                                      {0, 0, 2},
                                      {1, 1, 0},
                                      {1, 0, 1},
                                      {0, 1, 1}}) {
            const int derivative = derivative_by(x, y, z);
            std::array<Real, FieldRange::answers> range{};
            {
                const UpwardRounding upward;
                field.ranges(derivative, box.data(), range.data(), 1);
            }
            if (range[FieldRange::everywhere] != Real(1)) continue;
            const double of = value_at(field, point, derivative)[0];
            expect_in(range.data(), of, 1e-9 * (1 + std::abs(of)));
        }
    }
    return tight;
}

/// Checks that lanes are answered as they are alone, to the last bit.
template <class Real>
void expect_lanes_alike(const zeroset::Field& field, const auto& some_box) {
    for (const std::size_t lanes : {2U, 16U, 48U}) {
        std::vector<Real> in(9 * lanes);
        std::vector<std::array<Real, 9>> boxes(lanes);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            boxes[lane] = some_box();
            for (std::size_t i = 0; i < 9; ++i)
                in[i * lanes + lane] = boxes[lane][i];
        }
        std::vector<Real> forms(FieldForm::answers * lanes);
        field.forms(in.data(), forms.data(), static_cast<int>(lanes));
        std::vector<Real> values(FieldValue::answers * lanes);
        field.values(0, in.data() + 6 * lanes, values.data(), static_cast<int>(lanes));
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            std::array<Real, FieldForm::answers> form{};
            field.forms(boxes[lane].data(), form.data(), 1);
            for (std::size_t i = 0; i < form.size(); ++i)
                EXPECT_EQ(forms[i * lanes + lane], form[i]) << field.text();
            std::array<Real, FieldValue::answers> value{};
            field.values(0, boxes[lane].data() + 6, value.data(), 1);
            for (std::size_t i = 0; i < value.size(); ++i)
                EXPECT_EQ(values[i * lanes + lane], value[i]) << field.text();
        }
    }
}

}  // namespace zeroset::test
