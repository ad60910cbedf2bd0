#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/surface_functions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace zeroset::test::root_witnesses_test {
namespace {

std::string domain_of(const std::string& text) {
    const auto witness = domain_witness(*parse(text));
    return witness ? witness->canonical() : "";
}

/// Whether f is proved continuous from lo to hi in x, y and z.
bool continuous(const std::string& text, double lo, double hi) {
    const UpwardRounding upward;
    std::array<double, batch_multiple> neg_lo{};
    std::array<double, batch_multiple> ends{};
    std::array<double, batch_multiple> f_neg_lo{};
    std::array<double, batch_multiple> f_hi{};
    std::array<ContinuityMask<double>, batch_multiple> result{};
    neg_lo.fill(-lo);
    ends.fill(hi);
    Uniforms uniforms;
    uniforms.set(0, 0.0);
    interpret(*parse(text))
        .range(RangeBatchOf<double>{.size = batch_multiple,
                                    .neg_lo = {neg_lo.data(), neg_lo.data(), neg_lo.data()},
                                    .hi = {ends.data(), ends.data(), ends.data()},
                                    .uniforms = uniforms.boxes<double>(),
                                    .f_neg_lo = f_neg_lo.data(),
                                    .f_hi = f_hi.data(),
                                    .continuous = result.data()});
    return result[0] != 0;
}

std::string roots_of(const std::string& text) {
    std::string all;
    for (const Expr& witness : root_witnesses(*parse(text)))
        all += (all.empty() ? "" : "; ") + witness.canonical();
    return all;
}

TEST(RootWitnesses, OfRemaindersCrossZero) {
    EXPECT_EQ(roots_of("mod(x, y)"), "mod(x + y/2, y) - y/2");
    EXPECT_EQ(roots_of("3*frac(x)^2"), "mod(x + 1/2, 1) - 1/2");
    EXPECT_EQ(roots_of("ceil(x) - x"), "mod(x + 1/2, 1) - 1/2");
    EXPECT_EQ(roots_of("x - floor(y)"), "");
}

TEST(DomainWitness, IsOfTheOperatorsThatLackValues) {
    EXPECT_EQ(domain_of("sqrt(x) + y"), "sqrt(x)");
    EXPECT_EQ(domain_of("atan2(y, x) - z"), "1/(y^2 + x^2)");
    EXPECT_EQ(domain_of("mod(x, y) + log(z)"), "1/y + ln(z)");
    EXPECT_EQ(domain_of("x/(y - 1)"), "1/(y - 1)");
}

TEST(DomainWitness, IsNoneWhereNoneIsNeededOrKnown) {
    EXPECT_EQ(domain_of("x^2 + sqrt(y^2) - floor(z)/3"), "");
    EXPECT_FALSE(domain_witness(*parse("sqrt(x) - y, x < 1")));
}

TEST(DomainWitness, IsContinuousWhereJumpsAreDefined) {
    const std::string angle = "if(atan2(z, x) < 0.7, x, y)";
    EXPECT_FALSE(continuous(angle, 0.5, 1.0)) << "the jump is in the box";
    const auto witness = domain_witness(*parse(angle));
    ASSERT_TRUE(witness);
    EXPECT_TRUE(continuous(witness->canonical(), 0.5, 1.0));
    EXPECT_FALSE(continuous(witness->canonical(), -0.5, 1.0)) << "the origin is";
}

TEST(Extremes, DoNotJumpWhereTheOtherOperandDoes) {
    EXPECT_TRUE(continuous("min(floor(x) + 10, y)", 0.5, 1.5));
    EXPECT_TRUE(continuous("min(y, floor(x) + 10)", 0.5, 1.5));
    EXPECT_TRUE(continuous("max(floor(x) - 10, y)", 0.5, 1.5));
    EXPECT_FALSE(continuous("max(floor(x) + 10, y)", 0.5, 1.5));
    EXPECT_FALSE(continuous("min(floor(x), y)", 0.5, 1.5));
    EXPECT_FALSE(continuous("min(1/x + 100, y)", -0.5, 0.5)) << "the pole is one of the least";
}

}  // namespace
}  // namespace zeroset::test::root_witnesses_test
