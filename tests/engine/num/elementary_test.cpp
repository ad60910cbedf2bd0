#include "engine/num/elementary.hpp"

#include "engine/expr/op.hpp"
#include "engine/num/rounding.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>
#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

// The library's functions: their greatest measured error stays below the bound by which
// enclosures are widened, in any rounding mode of the caller, with the same bits at any width.

namespace zeroset::test {
namespace {

constexpr float largest = std::numeric_limits<float>::max();
constexpr float smallest = std::numeric_limits<float>::min();

struct Function {
    Elementary id;
    Op op;
    const char* name;
    double (*close)(double, double);  ///< by the C library, within a few ulp of a double
};

/// The operator of the same name, which the reference knows.
Op op_of(Elementary function) {
    if (function == Elementary::Cbrt) return Op::OddRoot;
    static constexpr std::string_view names[] = {
#define ZEROSET_SLEEF(id, arity, name, accuracy, bound_ulp, overflow) #id,
#include "engine/num/sleef_functions.def"
#undef ZEROSET_SLEEF
    };
    return std::ranges::find(operators(), names[static_cast<std::size_t>(function)], &OpInfo::name)
        ->op;
}

const Function functions[] = {
#define ZEROSET_SLEEF(id, arity, name, accuracy, bound_ulp, overflow) \
    ZEROSET_FUNCTION_##arity(id, name)
#define ZEROSET_FUNCTION_1(id, name) \
    {Elementary::id, op_of(Elementary::id), #name, [](double a, double) { return std::name(a); }},
#define ZEROSET_FUNCTION_2(id, name)               \
    {Elementary::id, op_of(Elementary::id), #name, \
     [](double a, double b) { return std::name(a, b); }},
#include "engine/num/sleef_functions.def"
#undef ZEROSET_SLEEF
#undef ZEROSET_FUNCTION_1
#undef ZEROSET_FUNCTION_2
};

float from_bits(std::uint64_t bits) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

/// Calls `visit(a, b)` for about two million operands: all exponents evenly, and where it is hard.
void visit_operands(Elementary function, const std::function<void(float, float)>& visit) {
    RandomNumbers random(30 + static_cast<std::uint64_t>(function));
    constexpr std::uint64_t stride = 4091;  // over 2^32 patterns: a million of them
    for (std::uint64_t bits = random.below(stride); bits < (1ULL << 32U); bits += stride) {
        visit(from_bits(bits), from_bits(random.bits()));
    }
    for (int i = 0; i < 300'000; ++i) {
        const auto k = static_cast<double>(random.below(1U << random.below(24)));
        const auto quarter_turns = static_cast<float>(k * (0.5 * std::numbers::pi));
        visit(random.nudged(quarter_turns), random.nudged(static_cast<float>(k)));
        visit(static_cast<float>(random.uniform(-104, 89)), 1.0F);
        visit(static_cast<float>(random.uniform(-1, 1)), static_cast<float>(random.uniform(-1, 1)));
        visit(random.number<float>(), random.number<float>());
    }
}

/// The distance of neighbouring floats at a normal number.
double ulp(double value) {
    int exponent = 0;
    std::frexp(value, &exponent);
    return std::ldexp(1.0, exponent - std::numeric_limits<float>::digits);
}

/// The greatest error of one function over all operands shown to it.
class WorstError {
public:
    explicit WorstError(const Function& function) : function_(function) {}

    void add(float a, float b) {
        const float result = elementary(function_.id, a, b);
        const double close = function_.close(static_cast<double>(a), static_cast<double>(b));
        if (std::isnan(close) || std::isinf(close)) return check_special(a, b, result, close);
        ++count_;
        const double size = std::abs(close);
        const double error = std::abs(close - static_cast<double>(result));
        if (std::isinf(result) && size >= elementary_overflow(function_.id)) return;
        if (size < static_cast<double>(smallest)) {
            EXPECT_LE(error, static_cast<double>(smallest)) << place(a, b);
        } else if (size <= static_cast<double>(largest)) {
            // The double is off by less than 2^-28 of a float's ulp: it decides what is worth a
            // look in full precision.
            const bool look = error / ulp(close) > 0.999 * ulps_ || count_ % 64 == 0;
            if (look) add_exactly(a, b, result);
        } else if (!std::isinf(result)) {
            EXPECT_EQ(std::abs(result), largest) << place(a, b);
        }
    }

    void report() const {
        std::printf("%-6s %8llu operands  worst %.4f ulp at (%a, %a)  bound %.1f\n", function_.name,
                    static_cast<unsigned long long>(count_), ulps_, static_cast<double>(a_),
                    static_cast<double>(b_), elementary_bound_ulp(function_.id));
        EXPECT_GT(count_, 100'000);
        EXPECT_GT(ulps_, 0.5);
        EXPECT_LT(ulps_, elementary_bound_ulp(function_.id));
    }

private:
    [[nodiscard]] std::string place(float a, float b) const {
        char text[80];
        std::snprintf(text, sizeof text, "%s(%a, %a)", function_.name, static_cast<double>(a),
                      static_cast<double>(b));
        return text;
    }

    void check_special(float a, float b, float result, double close) const {
        if (std::isnan(a) || std::isnan(b)) return;
        if (std::isnan(close)) {
            EXPECT_TRUE(std::isnan(result)) << place(a, b);
        } else {
            EXPECT_EQ(static_cast<double>(result), close) << place(a, b);
        }
    }

    void add_exactly(float a, float b, float result) {
        const Reference truth = reference(function_.op, 3, MpfrNumber(static_cast<double>(a)),
                                          MpfrNumber(static_cast<double>(b)));
        if (!truth.defined || truth.is_unknown()) return;  // infinite operands, atan2(0, 0)
        const double error =
            std::abs((truth.value - MpfrNumber(static_cast<double>(result))).nearest());
        const double ulps = error / ulp(truth.value.nearest());
        if (!(ulps > ulps_)) return;
        ulps_ = ulps;
        a_ = a;
        b_ = b;
    }

    Function function_;
    std::uint64_t count_ = 0;
    double ulps_ = 0.0;
    float a_ = 0.0F;
    float b_ = 0.0F;
};

TEST(Elementary, ErrorsStayBelowTheirBounds) {
    for (const Function& function : functions) {
        WorstError worst(function);
        visit_operands(function.id, [&](float a, float b) { worst.add(a, b); });
        worst.report();
    }
}

// 256 bits hold the nearest double, unless the value is closer than 2^-200 to a midpoint.
TEST(Elementary, RoundsDoublesCorrectly) {
    RandomNumbers random(33);
    for (int i = 0; i < 3000; ++i) {
        const auto a = random.number<double>();
        const auto b = random.number<double>();
        for (const Function& function : functions) {
            const Reference truth = reference(function.op, 3, MpfrNumber(a), MpfrNumber(b));
            if (truth.is_unknown()) continue;
            const double found = elementary(function.id, a, b);
            if (truth.defined) {
                ASSERT_EQ(found, truth.value.nearest())
                    << function.name << " at " << a << ", " << b;
            } else if (a != 0 && std::abs(a) != 1) {  // a limit at the domain's end is no value
                ASSERT_TRUE(std::isnan(found)) << function.name << " at " << a << ", " << b;
            }
        }
    }
    EXPECT_EQ(elementary(Elementary::Exp, -745.0), 0x1p-1074);
    EXPECT_EQ(elementary(Elementary::Sinh, 1e-320), 1e-320);
    EXPECT_TRUE(std::isinf(elementary(Elementary::Exp, 710.0)));
}

template <int Mode>
float in_mode(Elementary function, float a, float b) {
    const RoundingGuard<Mode> guard;
    return elementary(function, a, b);
}

bool same(float a, float b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

TEST(Elementary, IgnoresTheCallersRoundingMode) {
    RandomNumbers random(31);
    for (int i = 0; i < 200'000; ++i) {
        const auto a = random.number<float>();
        const auto b = random.number<float>();
        for (const Function& function : functions) {
            const float expected = elementary(function.id, a, b);
            ASSERT_TRUE(same(expected, in_mode<FE_UPWARD>(function.id, a, b)))
                << function.name << " at " << a << ", " << b;
            ASSERT_TRUE(same(expected, in_mode<FE_DOWNWARD>(function.id, a, b)))
                << function.name << " at " << a << ", " << b;
        }
    }
}

TEST(Elementary, LeavesTheCallersRoundingMode) {
    for (const Function& function : functions) {
        const UpwardRounding upward;
        const unsigned before = _mm_getcsr() & ~0x3FU;  // without the sticky exception flags
        const volatile float result = elementary(function.id, 0.3F, 0.4F);
        const volatile double wide = elementary(function.id, 0.3, 0.4);
        EXPECT_EQ(std::fegetround(), FE_UPWARD) << result << wide;
        EXPECT_EQ(_mm_getcsr() & ~0x3FU, before);
    }
}

constexpr std::size_t widest = 16;
using Caller = void (*)(void* code, int arity, const float* a, const float* b, float* out);

void call_4(void* code, int arity, const float* a, const float* b, float* out) {
    const __m128 x = _mm_loadu_ps(a);
    const __m128 result =
        arity == 1 ? reinterpret_cast<__m128 (*)(__m128)>(code)(x)
                   : reinterpret_cast<__m128 (*)(__m128, __m128)>(code)(x, _mm_loadu_ps(b));
    _mm_storeu_ps(out, result);
}

__attribute__((target("avx2"))) void call_8(void* code, int arity, const float* a, const float* b,
                                            float* out) {
    const __m256 x = _mm256_loadu_ps(a);
    const __m256 result =
        arity == 1 ? reinterpret_cast<__m256 (*)(__m256)>(code)(x)
                   : reinterpret_cast<__m256 (*)(__m256, __m256)>(code)(x, _mm256_loadu_ps(b));
    _mm256_storeu_ps(out, result);
}

__attribute__((target("avx512f"))) void call_16(void* code, int arity, const float* a,
                                                const float* b, float* out) {
    const __m512 x = _mm512_loadu_ps(a);
    const __m512 result =
        arity == 1 ? reinterpret_cast<__m512 (*)(__m512)>(code)(x)
                   : reinterpret_cast<__m512 (*)(__m512, __m512)>(code)(x, _mm512_loadu_ps(b));
    _mm512_storeu_ps(out, result);
}

void compare_with_one_lane(const Function& function, std::size_t lanes, Caller call) {
    // A pointer to a function has no const to keep.
    auto* const code = const_cast<void*>(elementary_code(function.id, static_cast<int>(lanes)));
    if (code == nullptr) return;
    RandomNumbers random(32);
    for (int i = 0; i < 40'000; ++i) {
        float a[widest];
        float b[widest];
        float found[widest] = {};
        for (std::size_t k = 0; k < lanes; ++k) {
            a[k] = random.one_in(2) ? from_bits(random.bits()) : random.number<float>();
            b[k] = random.number<float>();
        }
        call(code, elementary_arity(function.id), a, b, found);
        for (std::size_t k = 0; k < lanes; ++k) {
            ASSERT_TRUE(same(elementary(function.id, a[k], b[k]), found[k]))
                << function.name << " of " << lanes << " lanes at " << a[k] << ", " << b[k];
        }
    }
}

TEST(Elementary, HasTheSameBitsAtEveryWidth) {
    for (const Function& function : functions) {
        compare_with_one_lane(function, 4, call_4);
        compare_with_one_lane(function, 8, call_8);
        compare_with_one_lane(function, 16, call_16);
    }
}

TEST(Elementary, HasCodeForOneAndFourLanesEverywhere) {
    for (const Function& function : functions) {
        EXPECT_NE(elementary_code(function.id, 1), nullptr);
        EXPECT_NE(elementary_code(function.id, 4), nullptr);
        for (const int lanes : {-1, 0, 2, 3, 5, 32}) {
            EXPECT_EQ(elementary_code(function.id, lanes), nullptr);
        }
        EXPECT_EQ(elementary_arity(function.id), function.id == Elementary::Atan2 ? 2 : 1);
    }
}

}  // namespace
}  // namespace zeroset::test
