#include "engine/real/rounding.hpp"

#include "engine/real/scalar.hpp"
#include "tests/support/host_control.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>

namespace zeroset::test::rounding_test {
namespace {

/// -1/3 in the current mode; the nearest float is the one below. The volatile numbers keep the
/// division between the calls around it.
float third() {
    const volatile float one = -1.0F;
    const volatile float three = 3.0F;
    const volatile float quotient = one / three;
    return quotient;
}

template <int mode>
float third_in_mode() {
    const RoundingGuard<mode> guard;
    return third();
}

TEST(RoundingGuard, RoundsInItsMode) {
    EXPECT_EQ(third_in_mode<FE_TONEAREST>(), -0x1.555556p-2F);
    EXPECT_EQ(third_in_mode<FE_DOWNWARD>(), -0x1.555556p-2F);
    EXPECT_EQ(third_in_mode<FE_UPWARD>(), -0x1.555554p-2F);
}

TEST(UpwardRegisters, RoundVectorRegistersOnly) {
    {
        const UpwardRegisters upward;
        EXPECT_TRUE(rounds_upward());
        EXPECT_EQ(third(), -0x1.555554p-2F);
        {
            const NearestRounding nearest;
            EXPECT_EQ(third(), -0x1.555556p-2F);
        }
        EXPECT_TRUE(rounds_upward());
        EXPECT_EQ(std::fegetround(), FE_TONEAREST);
    }
    EXPECT_FALSE(rounds_upward());
    EXPECT_EQ(third(), -0x1.555556p-2F);
}

TEST(RoundingGuard, RestoresTheModeBefore) {
    ASSERT_EQ(std::fegetround(), FE_TONEAREST);
    {
        const UpwardRounding upward;
        EXPECT_EQ(std::fegetround(), FE_UPWARD);
        {
            const DownwardRounding downward;
            EXPECT_EQ(std::fegetround(), FE_DOWNWARD);
            const NearestRounding nearest;
            EXPECT_EQ(std::fegetround(), FE_TONEAREST);
        }
        EXPECT_EQ(std::fegetround(), FE_UPWARD);
        {
            const NearestCall call;  // sets vector registers only: fegetround does not see it
            EXPECT_EQ(third(), -0x1.555556p-2F);
        }
        EXPECT_EQ(third(), -0x1.555554p-2F);
        EXPECT_EQ(std::fegetround(), FE_UPWARD);
    }
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(RoundingGuard, WorksAndRestoresInEveryModeOfTheHost) {
    for (const int mode : all_modes) {
        for (const unsigned flush : all_flushes) {
            const HostControl host(mode, flush);
            const unsigned before = control();
            EXPECT_EQ(third_in_mode<FE_UPWARD>(), -0x1.555554p-2F);
            EXPECT_EQ(third_in_mode<FE_DOWNWARD>(), -0x1.555556p-2F);
            EXPECT_EQ(control(), before);
            EXPECT_EQ(std::fegetround(), mode);
        }
    }
}

/// smallest normal / 4 * 2, through a denormal: 0 where denormals are flushed.
float through_a_denormal() {
    const volatile float normal = std::numeric_limits<float>::min();
    const volatile float quarter = 0.25F;
    const volatile float denormal = normal * quarter;
    const volatile float two = 2.0F;
    const volatile float half = denormal * two;
    return half;
}

TEST(RoundingGuard, KeepsDenormalsThatTheHostFlushes) {
    const HostControl host(FE_TONEAREST, flush_all);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(through_a_denormal()), 0U);
    {
        const UpwardRounding upward;
        EXPECT_TRUE(rounds_upward());
        EXPECT_EQ(std::bit_cast<std::uint32_t>(through_a_denormal()), 0x400000U);
        {
            const NearestCall call;
            EXPECT_EQ(std::bit_cast<std::uint32_t>(through_a_denormal()), 0x400000U);
        }
        EXPECT_TRUE(rounds_upward());
    }
    EXPECT_FALSE(rounds_upward());
    EXPECT_EQ(std::bit_cast<std::uint32_t>(through_a_denormal()), 0U);
}

TEST(RoundingGuard, IsNotUpwardWhileTheHostFlushes) {
    const UpwardRounding upward;
    for (const unsigned flush : all_flushes) {
        const HostControl host(FE_UPWARD, flush);
        EXPECT_EQ(rounds_upward(), flush == 0U);
    }
}

TEST(RoundingGuard, RestoresTheModeAfterAnException) {
    try {
        const UpwardRounding upward;
        throw 1;
    } catch (int) {
        EXPECT_EQ(std::fegetround(), FE_TONEAREST);
    }
}

TEST(RoundingGuard, IsOfItsThread) {
    int in_other = -1;
    std::jthread other([&] {
        const UpwardRounding upward;
        in_other = std::fegetround();
    });
    other.join();
    EXPECT_EQ(in_other, FE_UPWARD);
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

template <int mode>
void expect_smallest_float_above() {
    const RoundingGuard<mode> guard;
    EXPECT_EQ(float_above(0.5), 0.5F);
    EXPECT_EQ(float_above(0.1), 0x1.99999ap-4F);
    EXPECT_EQ(float_above(-0.1), -0x1.999998p-4F);
    EXPECT_EQ(float_above(1e-300), std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(float_above(-1e-300), 0.0F);
    EXPECT_EQ(float_above(1e300), std::numeric_limits<float>::infinity());
    EXPECT_EQ(float_above(-1e300), std::numeric_limits<float>::lowest());
}

TEST(FloatAbove, IsTheSameInEveryMode) {
    expect_smallest_float_above<FE_TONEAREST>();
    expect_smallest_float_above<FE_UPWARD>();
    expect_smallest_float_above<FE_DOWNWARD>();
}

TEST(SelectNegative, SeesTheSignOfZero) {
    EXPECT_EQ(select_negative(-0.0F, 1.0F, 2.0F), 1.0F);
    EXPECT_EQ(select_negative(0.0F, 1.0F, 2.0F), 2.0F);
}

TEST(Maximum, TakesTheSecondOfUnordered) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(maximum(nan, 1.0F), 1.0F);
    EXPECT_TRUE(std::isnan(maximum(1.0F, nan)));
    EXPECT_EQ(minimum(nan, 1.0F), 1.0F);
    EXPECT_FALSE(std::signbit(maximum(-0.0F, 0.0F)));
    EXPECT_TRUE(std::signbit(maximum(0.0F, -0.0F)));
}

}  // namespace
}  // namespace zeroset::test::rounding_test
