#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/num/elementary.hpp"
#include "engine/num/periodic.hpp"
#include "engine/real/block.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>

// Tests that interval operations before and after a call that switches to round-to-nearest and back
// are rounded upward, though the compiler sees the same operands on both sides. The values tested
// differ in the two modes.

namespace zeroset::test::switches_test {
namespace {

/// Enclosure of 1/3 in upward rounding, as (-lo, hi).
template <class Real>
constexpr Interval<Real> third =
    sizeof(Real) == 4 ? Interval<Real>{Real(-0x1.555554p-2), Real(0x1.555556p-2)}
                      : Interval<Real>{Real(-0x1.5555555555555p-2), Real(0x1.5555555555556p-2)};

template <class Real>
Real first_lane(const Real& number) {
    return number;
}
template <class Real>
Real first_lane(const Block<Real>& block) {
    Real lane{};
    std::memcpy(&lane, &block, sizeof lane);
    return lane;
}

/// A quotient, a call, and the same quotient again. Not inlined into the function that holds the
/// guard, but itself inlines the operations, as kernels' algebra does.
template <class Lanes>
[[gnu::noinline]] std::array<Interval<Lanes>, 3> around_a_call(const Interval<Lanes>& one,
                                                               const Interval<Lanes>& three) {
    const Interval<Lanes> before = one / three;
    const Interval<Lanes> called = sin(three);
    const Interval<Lanes> after = one / three;
    return {before, called, after};
}

template <class Real>
class Switches : public ::testing::Test {
protected:
    template <class Lanes>
    static void expect_upward(const Interval<Lanes>& one, const Interval<Lanes>& three) {
        const auto [before, called, after] = around_a_call(one, three);
        for (const auto& found : {before, after}) {
            EXPECT_EQ(first_lane(found.neg_lo), third<Real>.neg_lo);
            EXPECT_EQ(first_lane(found.hi), third<Real>.hi);
        }
        EXPECT_NEAR(first_lane(called.hi), 0.1411200081, 1e-5);
        EXPECT_TRUE(rounds_upward());
    }
};
TYPED_TEST_SUITE(Switches, RealTypes, RealTypeNames);

TYPED_TEST(Switches, LeaveNumbersUpward) {
    const UpwardRounding upward;
    TestFixture::expect_upward(point(TypeParam(1)), point(TypeParam(3)));
}

TYPED_TEST(Switches, LeaveBlocksUpward) {
    using Lanes = Block<TypeParam>;
    const UpwardRounding upward;
    TestFixture::expect_upward(point(Lanes::splat(1)), point(Lanes::splat(3)));
}

TYPED_TEST(Switches, OfEveryFunctionLeaveUpward) {
    using Lanes = Block<TypeParam>;
    const UpwardRounding upward;
    const Lanes half = Lanes::splat(TypeParam(0.5));
    const auto expect_third = [&] {
        const auto found = point(Lanes::splat(1)) / point(Lanes::splat(3));
        EXPECT_EQ(first_lane(found.neg_lo), third<TypeParam>.neg_lo);
        EXPECT_EQ(first_lane(found.hi), third<TypeParam>.hi);
    };
#define ZEROSET_CALL_1(id) elementary(Elementary::id, half)
#define ZEROSET_CALL_2(id) elementary(Elementary::id, half, half)
#define ZEROSET_SLEEF(id, arity, name, accuracy, float_ulp, float_overflow, double_ulp, \
                      double_overflow)                                                  \
    {                                                                                   \
        SCOPED_TRACE(#id);                                                              \
        const volatile TypeParam result = first_lane(ZEROSET_CALL_##arity(id));         \
        static_cast<void>(result);                                                      \
        EXPECT_TRUE(rounds_upward());                                                   \
        expect_third();                                                                 \
    }
#include "engine/real/sleef_functions.def"
#undef ZEROSET_SLEEF
#undef ZEROSET_CALL_1
#undef ZEROSET_CALL_2
}

TEST(KernelDeathTest, RefusesOtherModes) {
    ::testing::GTEST_FLAG(death_test_style) = "threadsafe";
    const Kernel kernel = interpret(*parse("x"));
    std::array<float, batch_multiple> zeros{};
    std::array<std::uint32_t, batch_multiple> masks{};
    const float uniforms[2] = {};
    float* const data = zeros.data();
    const RangeBatch batch{batch_multiple, {data, data, data}, {data, data, data}, uniforms, data,
                           data,           masks.data()};
    EXPECT_DEATH(kernel.range(batch), "rounds_upward");
    const UpwardRounding upward;
    kernel.range(batch);
    EXPECT_EQ(masks[0], ~0U);
}

}  // namespace
}  // namespace zeroset::test::switches_test
