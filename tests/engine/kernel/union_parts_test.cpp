#include "engine/kernel/union_parts.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Unions as functions of which f is the least, and where each may be at most 0.

namespace zeroset::test::union_parts_test {
namespace {

constexpr ReachBox cube{{-1, -1, -1}, {1, 1, 1}};

Kernel kernel_of(const std::string& text) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr) << text;
    return expr ? interpret(*expr) : Kernel{};
}

Uniforms uniforms_of(double w_lo, double w_hi) {
    Uniforms uniforms;
    uniforms.set(0, w_lo, w_hi);
    return uniforms;
}

Reach reach_in_cube(const std::string& text, double w_lo = 0.5, double w_hi = 0.5) {
    const Kernel kernel = kernel_of(text);
    const UpwardRounding upward;
    return reach_of(kernel, cube, uniforms_of(w_lo, w_hi).boxes<float>());
}

using Points = std::array<std::array<float, batch_multiple>, 3>;

Points random_points(RandomNumbers& random) {
    Points points;
    for (auto& column : points) {
        for (float& x : column)
            x = static_cast<float>(random.uniform(-1, 1));
    }
    return points;
}

std::array<float, batch_multiple> values_at(const Kernel& kernel, const Points& points) {
    std::array<float, batch_multiple> f;
    std::array<std::array<float, batch_multiple>, 3> gradient;
    const Uniforms uniforms = uniforms_of(0.5, 0.5);
    const UpwardRounding upward;
    kernel.value(ValueBatch{batch_multiple,
                            {points[0].data(), points[1].data(), points[2].data()},
                            uniforms.points<float>(),
                            f.data(),
                            {gradient[0].data(), gradient[1].data(), gradient[2].data()}});
    return f;
}

TEST(Reach, IsTightAroundASphere) {
    const Reach reach = reach_in_cube("(x-0.3)^2 + (y+0.2)^2 + (z-0.1)^2 - 0.01");
    ASSERT_TRUE(reach.any);
    EXPECT_TRUE(reach.continuous);
    const std::array<float, 3> centre{0.3F, -0.2F, 0.1F};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LE(reach.box.lo[k], centre[k] - 0.1F);
        EXPECT_GE(reach.box.lo[k], centre[k] - 0.115F);
        EXPECT_GE(reach.box.hi[k], centre[k] + 0.1F);
        EXPECT_LE(reach.box.hi[k], centre[k] + 0.115F);
    }
}

TEST(Reach, IsNothingOfWhatIsAboveZero) {
    EXPECT_FALSE(reach_in_cube("x^2 + y^2 + z^2 + 0.1").any);
    EXPECT_TRUE(reach_in_cube("-1 - x^2").any);
}

TEST(Reach, HoldsWhereFIsUndefinedOrJumps) {
    const Reach undefined = reach_in_cube("sqrt(x) + 1");
    EXPECT_TRUE(undefined.any);
    EXPECT_FALSE(undefined.continuous);
    EXPECT_EQ(undefined.box.lo[0], -1.0F);
    const Reach pole = reach_in_cube("1/(x - 0.5)^2 + 1");
    EXPECT_TRUE(pole.any);
    EXPECT_FALSE(pole.continuous);
    EXPECT_LE(pole.box.lo[0], 0.5F);
    EXPECT_GE(pole.box.hi[0], 0.5F);
}

TEST(Reach, IsWithinTheBoxWhereFIsAboveZeroAtItsFaces) {
    EXPECT_TRUE(reach_in_cube("(x-0.5)^2 + y^2 + z^2 - 0.24999").within);
    EXPECT_FALSE(reach_in_cube("(x-0.5)^2 + y^2 + z^2 - 0.25").within);
    EXPECT_FALSE(reach_in_cube("x^2 + (y+0.5)^2 + z^2 - 0.2501").within);
    EXPECT_FALSE(reach_in_cube("z - 0.5").within);
    EXPECT_TRUE(reach_in_cube("max(|x|, |y|, |z|) - 0.9999").within);
    EXPECT_TRUE(reach_in_cube("x + 2").within);
}

TEST(Reach, IsThatOfAllValuesOfW) {
    const Reach reach = reach_in_cube("(x - w)^2 + y^2 + z^2 - 0.01", -0.5, 0.25);
    EXPECT_LE(reach.box.lo[0], -0.6F);
    EXPECT_GE(reach.box.hi[0], 0.35F);
    EXPECT_LE(reach.box.hi[0], 0.5F);
}

TEST(Reach, HoldsAllPointsThatAreNotAboveZero) {
    RandomNumbers random(11);
    for (const char* text :
         {"max(|x + 0.4| - 0.2, x^2 + 2y^2 - 0.5, z - 0.3)", "sin(5x) + y^2 - z",
          "(x^2 + y^2 + z^2 + 0.21)^2 - (x^2 + y^2)", "|x y| + |z| - 0.1", "log(y + z) + 2"}) {
        const Kernel kernel = kernel_of(text);
        const Reach reach = reach_in_cube(text);
        for (int batch = 0; batch < 200; ++batch) {
            const Points points = random_points(random);
            const auto f = values_at(kernel, points);
            for (std::size_t i = 0; i < f.size(); ++i) {
                bool beside = !reach.any;
                for (std::size_t k = 0; k < 3; ++k) {
                    beside =
                        beside || points[k][i] < reach.box.lo[k] || points[k][i] > reach.box.hi[k];
                }
                EXPECT_TRUE(!beside || f[i] > 0.0F) << text << ": " << f[i];
            }
        }
    }
}

TEST(UnionParts, IsMadeOfTheOperandsOfMin) {
    RandomNumbers random(7);
    const std::string text = "min(x, y^2 - z, max(sin(x), z), min(x y - 1, 3), y^2 - z)";
    const auto expr = parse(text);
    ASSERT_TRUE(expr);
    for (const Kernel& kernel : {interpret(*expr), interpret_with_parts(*expr)}) {
        const UnionParts* const union_parts = kernel.specializer->union_parts();
        ASSERT_NE(union_parts, nullptr);
        EXPECT_EQ(union_parts->kernels().size(), 5U);
        const Points points = random_points(random);
        std::array<float, batch_multiple> least;
        least.fill(std::numeric_limits<float>::infinity());
        for (const Kernel* operand : union_parts->kernels()) {
            const auto f = values_at(*operand, points);
            for (std::size_t i = 0; i < f.size(); ++i)
                least[i] = std::min(least[i], f[i]);
        }
        EXPECT_EQ(least, values_at(kernel, points));
    }
}

TEST(UnionParts, IsNotKnownOfOtherFunctions) {
    for (const char* text : {"max(x, y)", "min(x, y)^2", "max(min(x, y), z)"})
        EXPECT_EQ(kernel_of(text).specializer->union_parts(), nullptr) << text;
}

TEST(UnionParts, RemembersReachesOfTheLastBoxAndUniforms) {
    const Kernel kernel = kernel_of("min((x - w)^2 + y^2 + z^2 - 0.01, x + 5)");
    const UnionParts& union_parts = *kernel.specializer->union_parts();
    const auto first = union_parts.reaches(cube, uniforms_of(0.5, 0.5));
    EXPECT_EQ(union_parts.reaches(cube, uniforms_of(0.5, 0.5)), first);
    const auto moved = union_parts.reaches(cube, uniforms_of(-0.5, -0.5));
    EXPECT_LT((*moved)[0].box.hi[0], 0.0F);
    const auto beside = union_parts.reaches({{-1, -1, -1}, {-0.8F, 1, 1}}, uniforms_of(-0.5, -0.5));
    EXPECT_FALSE((*beside)[0].any);
    EXPECT_GT((*first)[0].box.lo[0], 0.0F);
    EXPECT_FALSE((*first)[1].any);
}

}  // namespace
}  // namespace zeroset::test::union_parts_test
