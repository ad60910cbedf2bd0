#include "engine/real/block.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

// Tests that enclosures over blocks are as narrow as their number type allows, so that no constant
// in them was chosen for a narrower type.

namespace zeroset::test::block_test {
namespace {

template <class Real>
class BlockEnclosures : public ::testing::Test {
protected:
    using Lanes = Block<Real>;

    static Interval<Lanes> box(Real lo, Real hi) { return {Lanes::splat(-lo), Lanes::splat(hi)}; }
    static Real first_lane(const Lanes& block) {
        Real lane{};
        std::memcpy(&lane, &block, sizeof lane);
        return lane;
    }
    static bool is_proved_defined(const Enclosure<Lanes>& f) {
        return !f.everywhere || (f.everywhere->bits & 1U) != 0;
    }

    /// Width of the operator's range at one point, in ulp of its upper end.
    static double width_ulp(const OpInfo& info, Real at) {
        const Facts facts;
        const Enclosure<Lanes> x{box(at, at)};
        const Operand<Enclosure<Lanes>> operand{x, facts};
        IntervalAlgebra<Lanes> algebra;
        const Node node{.op = info.op, .number = 5};
        const auto range = apply(algebra, node, operand, operand, operand).range;
        const Real hi = first_lane(range.hi);
        const Real width = hi + first_lane(range.neg_lo);
        const Real ulp = std::fabs(hi) * std::numeric_limits<Real>::epsilon();
        return width == 0 ? 0.0 : static_cast<double>(width / ulp);
    }

private:
    UpwardRounding upward_;
};
TYPED_TEST_SUITE(BlockEnclosures, RealTypes, RealTypeNames);

TYPED_TEST(BlockEnclosures, OfPointsHaveAWidthOfFewUlp) {
    for (const OpInfo& info : operators()) {
        const bool unary = info.arity == 1 && info.notation != Notation::Logic;
        if (!unary && info.op != Op::Atan2) continue;
        for (int i = 0; i < 50; ++i) {
            const double inside = 0.15 + 0.014 * i;
            const auto at = static_cast<TypeParam>(info.op == Op::Acosh ? 1 + inside : inside);
            EXPECT_LE(this->width_ulp(info, at), 20) << info.name << " at " << at;
        }
    }
}

TYPED_TEST(BlockEnclosures, OfAnglesMeetPiWithinAnUlp) {
    const auto beyond = angle(this->box(0, 0), this->box(-2, -1));
    const auto pi = static_cast<TypeParam>(std::numbers::pi);
    const TypeParam few_ulp = 4 * std::numeric_limits<TypeParam>::epsilon();
    EXPECT_NEAR(this->first_lane(beyond.range.hi), pi, few_ulp);
    EXPECT_NEAR(this->first_lane(beyond.range.neg_lo), -pi, few_ulp);
}

using DoubleBlockEnclosures = BlockEnclosures<double>;

TEST_F(DoubleBlockEnclosures, TellPolesFromTheirNeighbours) {
    for (const long double k : {0.0L, 1.0L, 10.0L, 1000.0L, 1e6L, 1e9L, 1e12L, -1.0L, -1e6L}) {
        const auto pole = static_cast<double>((k + 0.5L) * std::numbers::pi_v<long double>);
        const double ulp = std::nextafter(std::fabs(pole), infinity) - std::fabs(pole);
        EXPECT_TRUE(is_proved_defined(tan(box(pole - 0.5, pole - 8 * ulp)))) << pole;
        EXPECT_TRUE(is_proved_defined(tan(box(pole + 8 * ulp, pole + 0.5)))) << pole;
        EXPECT_FALSE(is_proved_defined(tan(box(pole - ulp, pole + ulp)))) << pole;
    }
    EXPECT_FALSE(is_proved_defined(tan(box(0x1p50, 0x1p50))));
}

}  // namespace
}  // namespace zeroset::test::block_test
