#include "engine/tape/parts.hpp"

#include "engine/algebra/graph_facts.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/kernel_batch.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/random_expression.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace zeroset::test::parts_test {
namespace {

Parts parts_in(const std::string& text, std::size_t most_nodes = 1000) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr) << text;
    return parts_of(*expr, facts_of(*expr), most_nodes);
}

/// The numbers of parts and of shapes, as "parts/shapes".
std::string counts(const std::string& text, std::size_t most_nodes = 1000) {
    const Parts parts = parts_in(text, most_nodes);
    return std::to_string(parts.parts.size()) + "/" + std::to_string(parts.shapes.size());
}

TEST(Parts, AreTheLargestGraphsWithoutChoices) {
    EXPECT_EQ(counts("min(x^2 + y, max(z^3 - 1, sin(x) y)) + z/3"), "4/4");
    EXPECT_EQ(counts("if(x + y < 1, z^2, min(w, 2) z)"), "3/3");
    EXPECT_EQ(counts("min(x, y)"), "0/0");
    EXPECT_EQ(counts("x^2 + y^2 + z^2 - 1"), "0/0");
}

TEST(Parts, OfEqualOperatorsHaveOneShape) {
    EXPECT_EQ(counts("min((x - 0.5)^2 + y, (x + 0.1)^2 + y, (x - sqrt(4))^2 + y)"), "3/1");
    EXPECT_EQ(counts("min((x - 0.5)^2 + y, (x - 0.5)^3 + y, (x - 0.5)^2 + z)"), "3/3");
    EXPECT_EQ(counts("min((x - 1)^2 + (y - 1)^2, (x - 2)^2 + (y - 3)^2)"), "2/1");
}

TEST(Parts, HaveTheConstantsInWhichTheyDifferAsUniforms) {
    const Parts parts = parts_in("min(a w (x - 0.5)^2 - 3, a w (x - 1)^2 - 3)");
    ASSERT_EQ(parts.shapes.size(), 1U);
    EXPECT_EQ(parts.shapes[0].shared, (std::vector<std::size_t>{1, 0}));
    EXPECT_NE(parts.shapes[0].expr.canonical().find('3'), std::string::npos);
    ASSERT_EQ(parts.parts.size(), 2U);
    const std::array formula{7.0, 9.0};
    for (const Part& part : parts.parts) {
        const double* const all = point_uniforms(parts.shapes[0], part, formula.data());
        EXPECT_EQ(all[0], 9.0);
        EXPECT_EQ(all[1], 7.0);
        EXPECT_EQ(part.uniforms.middle_double.size(), 3U);
        EXPECT_EQ(all[2], part.uniforms.middle_double[2]);
    }
    EXPECT_EQ(parts.parts[0].uniforms.middle_double[2] + parts.parts[1].uniforms.middle_double[2],
              -1.5);
}

/// Which is more than a rounding away from what is meant.
TEST(Parts, KeepAWideConstantInTheirShape) {
    ExprBuilder builder;
    const NodeId x = builder.variable(0);
    const auto less = [&](double lo, double hi) {
        return builder.apply(Op::Add, builder.apply(Op::IntPower, x, 0, 0, 2),
                             builder.constant(lo, hi));
    };
    const auto shapes = [&](NodeId a, NodeId b) {
        const Expr expr = builder.finish(builder.apply(Op::Min, a, b));
        return parts_of(expr, facts_of(expr), 1000).shapes.size();
    };
    EXPECT_EQ(shapes(less(1.5, 1.5 + 0x1p-52), less(2, 2)), 1U);
    EXPECT_EQ(shapes(less(1.5, 1.5 + 0x1p-49), less(2, 2)), 2U);
}

TEST(Parts, StayWithinTheNodesAllowed) {
    const std::string text = "min(x y z + x^2, (x - 1)^2, (x - 2)^2, (x - 3)^2, (x - 4)^2)";
    EXPECT_EQ(counts(text), "5/2");
    EXPECT_EQ(counts(text, 5), "4/1");
    EXPECT_EQ(counts(text, 3), "0/0");
    EXPECT_LE(parts_in(text, 5).nodes(), 5U);
}

TEST(Parts, WithoutCodeAreNone) {
    Parts parts = parts_in("min((x - 1)^2, y^3)");
    parts.make_code([](const Expr& shape) -> std::optional<Kernel> {
        if (shape.uses_variable(0)) return std::nullopt;
        return interpret(shape);
    });
    EXPECT_EQ(std::ranges::count(parts.of_node, Parts::none),
              static_cast<std::ptrdiff_t>(parts.of_node.size()) - 1);
}

/// Values do not depend on how constants come in. Gradients may where a derivative is infinite or
/// a zero has a sign.
TEST(InterpretWithParts, GivesTheValuesOfTheWhole) {
    RandomNumbers random(5);
    for (int i = 0; i < 400; ++i) {
        const Expr expr = random_expression(random, random.between(2, 5));
        const KernelBatch batch(random, 32);
        const auto in_parts = batch.run(interpret_with_parts(expr)).value;
        const auto whole = batch.run(interpret(expr)).value;
        ASSERT_EQ(in_parts.size(), whole.size());
        for (std::size_t k = 0; k < whole.size(); ++k) {
            // A NaN stands as one of double.
            const auto number = [k](const auto& bits) {
                const bool fits = bits[k] <= std::numeric_limits<std::uint32_t>::max();
                return fits ? std::bit_cast<float>(static_cast<std::uint32_t>(bits[k]))
                            : std::numeric_limits<float>::quiet_NaN();
            };
            const float a = number(in_parts);
            const float b = number(whole);
            const bool value = k < whole.size() / 4;
            if (value ? std::isnan(a) && std::isnan(b) : !std::isfinite(a) || !std::isfinite(b))
                continue;
            ASSERT_EQ(a, b) << expr.canonical();
        }
    }
}

}  // namespace
}  // namespace zeroset::test::parts_test
