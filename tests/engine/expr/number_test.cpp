#include "engine/expr/number.hpp"

#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <limits>
#include <string>

namespace zeroset::number_test {
namespace {

/// Rounds a decimal number to a double in the given direction.
double rounded(const std::string& digits, mpfr_rnd_t direction) {
    mpfr_t value;  // precision and exponents of a double, so that rounding happens once
    mpfr_init2(value, 53);
    const mpfr_exp_t emin = mpfr_get_emin();
    const mpfr_exp_t emax = mpfr_get_emax();
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
    char* end = nullptr;
    const int inexact = mpfr_strtofr(value, digits.c_str(), &end, 10, direction);
    mpfr_subnormalize(value, inexact, direction);
    EXPECT_EQ(*end, '\0') << digits;
    const double result = mpfr_get_d(value, direction);
    mpfr_clear(value);
    mpfr_set_emin(emin);
    mpfr_set_emax(emax);
    return result;
}

std::string random_literal(test::RandomNumbers& random) {
    std::string text;
    const auto digits = [&](std::size_t count) {
        for (; count > 0; --count)
            text += static_cast<char>('0' + random.below(10));
    };
    digits(1 + random.below(random.one_in(4) ? 40 : 6));
    if (random.one_in(2)) {
        text += '.';
        digits(random.below(30));
    }
    if (random.one_in(2)) text += "e" + std::to_string(random.between(-345, 260));
    return text;
}

TEST(EncloseNumber, AgreesWithMpfr) {
    test::RandomNumbers random(22);
    for (int i = 0; i < 50'000 && !testing::Test::HasFailure(); ++i) {
        const std::string text = random_literal(random);
        const NumberEnclosure number = enclose_number(text);
        EXPECT_EQ(number.lo, rounded(text, MPFR_RNDD)) << text;
        EXPECT_EQ(number.hi, rounded(text, MPFR_RNDU)) << text;
    }
}

TEST(EncloseNumber, IsExactForDoubles) {
    EXPECT_EQ(enclose_number("0"), (NumberEnclosure{0, 0}));
    EXPECT_EQ(enclose_number("0.5"), (NumberEnclosure{0.5, 0.5}));
    EXPECT_EQ(enclose_number("9007199254740993"),
              (NumberEnclosure{9007199254740992.0, 9007199254740994.0}));
    EXPECT_EQ(enclose_number("1e-400").lo, 0);
    EXPECT_EQ(enclose_number("1e-400").hi, std::numeric_limits<double>::denorm_min());
    EXPECT_TRUE(std::isinf(enclose_number("1e400").hi));
}

void expect_round_trip(const NumberEnclosure& number) {
    const std::string text = number_text(number);
    const NumberEnclosure again = enclose_number(text);
    EXPECT_EQ(again.lo, number.lo) << text;
    EXPECT_EQ(again.hi, number.hi) << text;
}

TEST(NumberText, RoundTrips) {
    test::RandomNumbers random(23);
    for (int i = 0; i < 20'000 && !testing::Test::HasFailure(); ++i) {
        expect_round_trip(enclose_number(random_literal(random)));
    }
}

TEST(NumberText, RoundTripsExactDoubles) {
    test::RandomNumbers random(24);
    for (int i = 0; i < 3000 && !testing::Test::HasFailure(); ++i) {
        const double value = random.number<double>();
        if (std::abs(value) < 1e-300 || std::abs(value) > 1e300) continue;
        expect_round_trip({value, value});
    }
    expect_round_trip({0x1p-1074, 0x1p-1074});
}

TEST(NumberText, IsShort) {
    EXPECT_EQ(number_text(enclose_number("0.1")), "0.1");
    EXPECT_EQ(number_text(enclose_number("0.10")), "0.1");
    EXPECT_EQ(number_text(enclose_number("1000")), "1000");
    EXPECT_EQ(number_text({-0.5, -0.5}), "-0.5");
}

}  // namespace
}  // namespace zeroset::number_test
