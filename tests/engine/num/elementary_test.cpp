#include "engine/num/elementary.hpp"

#include "engine/real/rounding.hpp"
#include "tests/support/elementary_functions.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>
#include <immintrin.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

// Tests of the library's functions: their greatest measured error is below the bound by which
// enclosures are widened; they give the same bits in any rounding mode of the caller and at any
// width.

namespace zeroset::test::elementary_test {
namespace {

/// Calls `visit(a, b)` for operands evenly over all exponents, and for as many where the functions
/// are hard to compute: in a long run two million in float, one million in double.
template <class Real>
void visit_operands(Elementary function, const std::function<void(Real, Real)>& visit) {
    RandomNumbers random(30 + static_cast<std::uint64_t>(function));
    constexpr bool is_float = sizeof(Real) == 4;
    const int evenly = (is_float ? 1'000'000 : 500'000) / (is_long_run() ? 1 : 5);
    const std::uint64_t stride =
        std::numeric_limits<Pattern<Real>>::max() / static_cast<Pattern<Real>>(evenly);
    std::uint64_t bits = random.below(stride);
    for (int i = 0; i < evenly; ++i, bits += stride)
        visit(from_bits<Real>(bits), from_bits<Real>(random.bits()));
    // This double is the closest, for its size, to a multiple of pi / 2.
    if constexpr (!is_float) visit(0x1.6ac5b262ca1ffp+849, 1.0);
    const double lowest = is_float ? -104 : -745;
    const double highest = is_float ? 89 : 710;
    for (int i = 0; i < evenly / 4; ++i) {
        const auto k = static_cast<double>(random.below(1ULL << random.below(is_float ? 24 : 48)));
        const auto quarter_turns = static_cast<Real>(k * (0.5 * std::numbers::pi));
        visit(random.nudged(quarter_turns), random.nudged(static_cast<Real>(k)));
        visit(static_cast<Real>(random.uniform(lowest, highest)), Real(1));
        visit(static_cast<Real>(random.uniform(-1, 1)), static_cast<Real>(random.uniform(-1, 1)));
        visit(random.number<Real>(), random.number<Real>());
    }
}

/// The distance between neighbouring numbers near a normal number.
template <class Real>
Wide<Real> ulp(Wide<Real> value) {
    int exponent = 0;
    std::frexp(value, &exponent);
    return std::ldexp(Wide<Real>(1), exponent - std::numeric_limits<Real>::digits);
}

/// The greatest error of a function over all operands that are added.
template <class Real>
class WorstError {
public:
    explicit WorstError(const Function<Real>& function) : function_(function) {}

    void add(Real a, Real b) {
        const Real result = one_lane(function_.id, a, b);
        const Wide<Real> close = function_.close(Wide<Real>(a), Wide<Real>(b));
        if (std::isnan(close) || std::isinf(close)) return check_special(a, b, result, close);
        ++count_;
        const Wide<Real> size = std::abs(close);
        const Wide<Real> error = std::abs(close - Wide<Real>(result));
        if (std::isinf(result) && size >= Wide<Real>(overflow())) return;
        if (size < Wide<Real>(smallest)) {
            EXPECT_LE(error, Wide<Real>(smallest)) << place(a, b);
        } else if (size <= Wide<Real>(largest)) {
            // `close` is off by less than a thousandth of an ulp: enough to select the operands
            // that are worth a computation in full precision.
            const auto ulps = static_cast<double>(error / ulp<Real>(close));
            if (ulps > 0.999 * ulps_ || count_ % 64 == 0) add_exactly(a, b, result);
        } else if (!std::isinf(result)) {
            EXPECT_EQ(std::abs(result), largest) << place(a, b);
        }
    }

    void report() const {
        const double bound = format_of(Real{}).bound(function_.id).ulp;
        std::printf("%-6s %8llu operands  worst %.4f ulp at (%a, %a)  bound %.1f\n", function_.name,
                    static_cast<unsigned long long>(count_), ulps_, static_cast<double>(a_),
                    static_cast<double>(b_), bound);
        EXPECT_GT(count_, 50'000);
        EXPECT_GT(ulps_, 0.5);
        EXPECT_LT(ulps_, bound);
    }

private:
    static constexpr Real largest = std::numeric_limits<Real>::max();
    static constexpr Real smallest = std::numeric_limits<Real>::min();

    [[nodiscard]] double overflow() const { return format_of(Real{}).bound(function_.id).overflow; }

    [[nodiscard]] std::string place(Real a, Real b) const {
        char text[80];
        std::snprintf(text, sizeof text, "%s(%a, %a)", function_.name, static_cast<double>(a),
                      static_cast<double>(b));
        return text;
    }

    void check_special(Real a, Real b, Real result, Wide<Real> close) const {
        if (std::isnan(a) || std::isnan(b)) return;
        if (std::isnan(close)) {
            EXPECT_TRUE(std::isnan(result)) << place(a, b);
        } else {
            EXPECT_EQ(Wide<Real>(result), close) << place(a, b);
        }
    }

    void add_exactly(Real a, Real b, Real result) {
        const Reference truth = reference(function_.op, 3, MpfrNumber(static_cast<double>(a)),
                                          MpfrNumber(static_cast<double>(b)));
        if (!truth.defined || truth.is_unknown()) return;  // infinite operands, atan2(0, 0)
        const double error =
            std::abs((truth.value - MpfrNumber(static_cast<double>(result))).nearest());
        const auto size = static_cast<Wide<Real>>(truth.value.nearest());
        const double ulps = error / static_cast<double>(ulp<Real>(size));
        if (!(ulps > ulps_)) return;
        ulps_ = ulps;
        a_ = a;
        b_ = b;
    }

    Function<Real> function_;
    std::uint64_t count_ = 0;
    double ulps_ = 0.0;
    Real a_{};
    Real b_{};
};

template <class Real>
class ElementaryCode : public ::testing::Test {
    /// Restores the rounding mode after each test, as the functions leave upward rounding behind.
    NearestRounding as_before_;
};
TYPED_TEST_SUITE(ElementaryCode, RealTypes, RealTypeNames);

TYPED_TEST(ElementaryCode, HasErrorsBelowTheirBounds) {
    for (const auto& function : functions<TypeParam>()) {
        WorstError<TypeParam> worst(function);
        visit_operands<TypeParam>(function.id, [&](TypeParam a, TypeParam b) { worst.add(a, b); });
        worst.report();
    }
}

// Compare with 256 bits: they give the nearest double unless the value is closer than 2^-200 to a
// midpoint.
TEST(CorrectlyRounded, IsTheNearestDouble) {
    RandomNumbers random(33);
    for (int i = 0; i < 3000; ++i) {
        const auto a = random.number<double>();
        const auto b = random.number<double>();
        for (const auto& function : functions<double>()) {
            const Reference truth = reference(function.op, 3, MpfrNumber(a), MpfrNumber(b));
            if (truth.is_unknown()) continue;
            const double found = correctly_rounded(function.id, a, b);
            if (truth.defined) {
                ASSERT_EQ(found, truth.value.nearest())
                    << function.name << " at " << a << ", " << b;
            } else if (a != 0 && std::abs(a) != 1) {  // a limit at the domain's end is no value
                ASSERT_TRUE(std::isnan(found)) << function.name << " at " << a << ", " << b;
            }
        }
    }
    EXPECT_EQ(correctly_rounded(Elementary::Exp, -745.0), 0x1p-1074);
    EXPECT_EQ(correctly_rounded(Elementary::Sinh, 1e-320), 1e-320);
    EXPECT_TRUE(std::isinf(correctly_rounded(Elementary::Exp, 710.0)));
}

template <int mode, class Real>
Real in_mode(Elementary function, Real a, Real b) {
    const RoundingGuard<mode> guard;
    return one_lane(function, a, b);
}

template <class Real>
bool same(Real a, Real b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<Pattern<Real>>(a) == std::bit_cast<Pattern<Real>>(b);
}

TYPED_TEST(ElementaryCode, IgnoresTheCallersRoundingMode) {
    RandomNumbers random(31);
    for (int i = 0; i < (is_long_run() ? 200'000 : 30'000); ++i) {
        const auto a = random.number<TypeParam>();
        const auto b = random.number<TypeParam>();
        for (const auto& function : functions<TypeParam>()) {
            const TypeParam expected = one_lane(function.id, a, b);
            ASSERT_TRUE(same(expected, in_mode<FE_UPWARD>(function.id, a, b)))
                << function.name << " at " << a << ", " << b;
            ASSERT_TRUE(same(expected, in_mode<FE_DOWNWARD>(function.id, a, b)))
                << function.name << " at " << a << ", " << b;
        }
    }
}

TYPED_TEST(ElementaryCode, LeavesTheCallersRoundingMode) {
    for (const auto& function : functions<TypeParam>()) {
        const UpwardRounding upward;
        const unsigned before = _mm_getcsr() & ~0x3FU;  // without the sticky exception flags
        const volatile TypeParam result = one_lane(function.id, TypeParam(0.3), TypeParam(0.4));
        const volatile double exact = correctly_rounded(function.id, 0.3, 0.4);
        EXPECT_EQ(std::fegetround(), FE_UPWARD) << result << exact;
        EXPECT_EQ(_mm_getcsr() & ~0x3FU, before);
    }
}

template <class Real>
void compare_with_one_lane(const Function<Real>& function, std::size_t bytes) {
    const auto [code, lanes, call] = wide_code<Real>(function.id, bytes);
    if (code == nullptr) return;
    RandomNumbers random(32);
    for (int i = 0; i < (is_long_run() ? 40'000 : 8'000); ++i) {
        Real a[most_lanes];
        Real b[most_lanes];
        Real found[most_lanes] = {};
        for (std::size_t k = 0; k < lanes; ++k) {
            a[k] = random.one_in(2) ? from_bits<Real>(random.bits()) : random.number<Real>();
            b[k] = random.number<Real>();
        }
        call(code, elementary_arity(function.id), a, b, found);
        for (std::size_t k = 0; k < lanes; ++k) {
            ASSERT_TRUE(same(one_lane(function.id, a[k], b[k]), found[k]))
                << function.name << " of " << lanes << " lanes at " << a[k] << ", " << b[k];
        }
    }
}

TYPED_TEST(ElementaryCode, HasTheSameBitsAtEveryWidth) {
    for (const auto& function : functions<TypeParam>()) {
        for (const std::size_t bytes : {16U, 32U, 64U})
            compare_with_one_lane<TypeParam>(function, bytes);
    }
}

TYPED_TEST(ElementaryCode, IsThereForTheLeastRegistersEverywhere) {
    constexpr int least = 16 / sizeof(TypeParam);
    for (const auto& function : functions<TypeParam>()) {
        EXPECT_NE(elementary_code(function.id, 1, type_of<TypeParam>), nullptr);
        EXPECT_NE(elementary_code(function.id, least, type_of<TypeParam>), nullptr);
        for (const int lanes : {-1, 0, least / 2 == 1 ? 3 : 2, 5, 8 * least, 128}) {
            EXPECT_EQ(elementary_code(function.id, lanes, type_of<TypeParam>), nullptr);
        }
        EXPECT_EQ(elementary_arity(function.id), function.id == Elementary::Atan2 ? 2 : 1);
    }
}

}  // namespace
}  // namespace zeroset::test::elementary_test
