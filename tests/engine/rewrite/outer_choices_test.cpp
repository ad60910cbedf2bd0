#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/rewrite/passes.hpp"
#include "tests/support/kernel_batch.hpp"
#include "tests/support/random_expression.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace zeroset::test::outer_choices_test {
namespace {

std::string moved(const char* text) { return with_outer_choices(parse(text).value()).canonical(); }
std::string written(const char* text) { return parse(text).value().canonical(); }

TEST(OuterChoices, LeaveNegationsSumsAndFactors) {
    EXPECT_EQ(moved("2 - min(x, y)"), written("max(2 - x, 2 - y)"));
    EXPECT_EQ(moved("min(x, max(y, z)) / 4 + x^2"),
              written("min(x/4 + x^2, max(y/4 + x^2, z/4 + x^2))"));
    EXPECT_EQ(moved("if(x < y, -min(x, z), y) * (-3)"),
              written("if(x < y, min(-x*(-3), -z*(-3)), y*(-3))"));
}

TEST(OuterChoices, StayWhereTheyAreUsedTwiceOrDecideOtherThings) {
    for (const char* text : {"min(x, y) + min(x, y)^2", "sin(min(x, y))", "min(x, y)*z",
                             "if(min(x, y) < z, x, y)", "min(x, y) - max(y, z)"}) {
        EXPECT_EQ(moved(text), written(text));
    }
}

/// How many floats apart.
std::int64_t distance(std::uint64_t a, std::uint64_t b) {
    const auto place = [](std::uint64_t bits) {
        const auto size = static_cast<std::int64_t>(bits & 0x7fffffffU);
        return (bits >> 31U & 1U) != 0 ? -size : size;
    };
    return std::abs(place(a) - place(b));
}

/// Constants that come together are rounded once.
TEST(OuterChoices, KeepValues) {
    RandomNumbers random(6);
    for (int i = 0; i < 400; ++i) {
        const Expr expr = random_expression(random, random.between(2, 5));
        const KernelBatch batch(random, 32);
        const auto after = batch.run(interpret(with_outer_choices(expr))).value;
        const auto before = batch.run(interpret(expr)).value;
        // The gradients behind the values may have zeros of another sign.
        for (std::size_t k = 0; k < before.size() / 4; ++k)
            EXPECT_LE(distance(after[k], before[k]), 1) << expr.canonical();
    }
}

}  // namespace
}  // namespace zeroset::test::outer_choices_test
