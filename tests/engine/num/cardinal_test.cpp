#include "engine/num/cardinal.hpp"

#include "engine/real/rounding.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

// That the ranges of values are right to the last bit is tested against MPFR (tests/oracle).

namespace zeroset::test::cardinal_test {
namespace {

/// A function's value and its first two derivatives.
using Values = std::array<long double, 3>;

/// f/x and its derivatives from those of f.
Values divided(const Values& f, long double x) {
    const long double value = f[0] / x;
    const long double slope = (f[1] - value) / x;
    return {value, slope, (f[2] - 2 * slope) / x};
}

Values values_at(Cardinal function, long double x) {
    const long double square = 1 + x * x;
    switch (function) {
        case Cardinal::Sin: return divided({std::sin(x), std::cos(x), -std::sin(x)}, x);
        case Cardinal::Sinh: return divided({std::sinh(x), std::cosh(x), std::sinh(x)}, x);
        case Cardinal::Atan:
            return divided({std::atan(x), 1 / square, -2 * x / (square * square)}, x);
    }
    return {};
}

template <class Real>
class CardinalRanges : public ::testing::Test {
protected:
    using Range = Interval<Real>;

    /// The ranges of a function and of its first two derivatives.
    static std::array<Range, 3> ranges(Cardinal function, const Range& x) {
        const UpwardRounding upward;
        const Range g = cardinal(function, x);
        const Range slope = cardinal_slope(function, x, g);
        return {g, slope, cardinal_bend(function, x, g, slope)};
    }
    static double width(const Range& a) { return static_cast<double>(a.neg_lo + a.hi); }
};

TYPED_TEST_SUITE(CardinalRanges, RealTypes);

TYPED_TEST(CardinalRanges, EncloseRandomBoxes) {
    RandomNumbers random(31);
    for (int n = 0; n < 3000; ++n) {
        const auto function = static_cast<Cardinal>(n % 3);
        const double middle = random.uniform(-25.0, 25.0);
        const double half = std::exp(random.uniform(-9.0, 2.0));
        const auto lo = static_cast<TypeParam>(middle - half);
        const auto hi = static_cast<TypeParam>(middle + half);
        const auto found = this->ranges(function, {-lo, hi});
        for (int k = 0; k < 20; ++k) {
            const auto x = static_cast<long double>(
                std::lerp(lo, hi, static_cast<TypeParam>(random.uniform())));
            if (std::abs(x) < 0.25L) continue;
            const Values exact = values_at(function, x);
            for (std::size_t i = 0; i < exact.size(); ++i) {
                ASSERT_LE(-found.at(i).neg_lo, exact.at(i)) << n << ": " << i << " at " << x;
                ASSERT_GE(found.at(i).hi, exact.at(i)) << n << ": " << i << " at " << x;
            }
        }
    }
}

/// A narrow box far from 0 has ranges about as narrow as the functions' own.
TYPED_TEST(CardinalRanges, AreNarrowFarFromZero) {
    for (const double middle : {3.25, 4.5, 7.75, 12.5, 31.0}) {
        const double half = 0x1p-10;
        for (const Cardinal function : {Cardinal::Sin, Cardinal::Atan}) {
            const auto found = this->ranges(function, {static_cast<TypeParam>(half - middle),
                                                       static_cast<TypeParam>(half + middle)});
            const double widest = 3.0 * half / middle;
            EXPECT_LT(this->width(found[0]), widest) << middle;
            EXPECT_LT(this->width(found[1]), 2.0 * widest) << middle;
            EXPECT_LT(this->width(found[2]), 3.0 * widest) << middle;
        }
    }
}

}  // namespace
}  // namespace zeroset::test::cardinal_test
