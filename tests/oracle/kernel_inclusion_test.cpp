#include "tests/oracle/kernel_inclusion.hpp"

#include "engine/expr/copy.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/by_pieces.hpp"
#include "tests/support/compiled.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <cstdio>

// Checks of range kernels of random formulas against MPFI.

namespace zeroset::test::kernel_inclusion_test {
namespace {

Kernel machine_code(const Expr& expr) { return compiled(expr, {.with_double = true}); }

template <class Real>
class KernelInclusion : public ::testing::Test {
protected:
    /// Returns the operators in the formulas that were tried.
    static std::set<Op> check(MakeKernel make, int count, std::uint64_t seed) {
        RandomNumbers random(seed);
        InclusionTally tally;
        for (int i = 0; i < count && tally.failures == 0; ++i)
            check_kernel<Real>(make, 1 + i % 6, random, tally);
        EXPECT_EQ(tally.failures, 0U) << tally.first;
        if (tally.failures > 0) return tally.operators;
        EXPECT_EQ(tally.checks, static_cast<std::uint64_t>(count) * boxes_a_batch * 8);
        std::printf("checked %llu points and boxes\n",
                    static_cast<unsigned long long>(tally.checks));
        return tally.operators;
    }
};
TYPED_TEST_SUITE(KernelInclusion, RealTypes, RealTypeNames);

TYPED_TEST(KernelInclusion, OfTheInterpreterHolds) {
    EXPECT_EQ(missing_operators(this->check(interpret, formulas_to_try(400), 11)), "");
}
TYPED_TEST(KernelInclusion, OfPartsHolds) {
    this->check(interpret_with_parts, formulas_to_try(40), 13);
}
TYPED_TEST(KernelInclusion, OfMachineCodeHolds) {
    this->check(machine_code, formulas_to_try(8), 12);
}
TYPED_TEST(KernelInclusion, OfPiecesHolds) {
    this->check([](const Expr& expr) { return by_pieces(interpret(expr)); }, formulas_to_try(40),
                14);
}
TYPED_TEST(KernelInclusion, OfPiecesInMachineCodeHolds) {
    this->check([](const Expr& expr) { return by_pieces(machine_code(expr)); }, formulas_to_try(6),
                15);
}

Expr parsed(const char* text) { return parse(text).value(); }

/// A kernel that computes atan instead of tanh.
Kernel planted_bug(const Expr& expr) {
    ExprBuilder builder;
    const auto copies = copy_nodes(
        builder, expr, [](ExprBuilder& to, const Node& node, NodeId a, NodeId b, NodeId c) {
            return node.op == Op::Tanh ? to.apply(Op::Atan, a) : copy_node(to, node, a, b, c);
        });
    return interpret(builder.finish(copies.back()));
}

TYPED_TEST(KernelInclusion, FailuresShrinkToThePlantedBug) {
    const Expr expr = parsed(
        "if(x < y and z < 4, sqrt(2 + cos(y*z)) - min(x, z)*(tanh(x*y + z) + exp(-w^2)), "
        "mod(x, y + 3)) + sin(3*atan2(y, x))");
    const auto at = [](double lo, double hi) {
        return Interval<TypeParam>{static_cast<TypeParam>(-lo), static_cast<TypeParam>(hi)};
    };
    const FormulaOnBox<TypeParam> start{
        expr, {at(1.237, 1.238), at(1.91, 1.9101), at(0.731, 0.732), at(-0.25, 0.001)}};
    ASSERT_NE(disproved(planted_bug, start), "");
    EXPECT_EQ(disproved(interpret, start), "");
    const auto fails = [](const auto& on) { return !disproved(planted_bug, on).empty(); };
    const auto small = shrunk(start, fails);
    EXPECT_EQ(small.expr.canonical(), "tanh(x)");
    EXPECT_NE(disproved(planted_bug, small), "");
    EXPECT_EQ(-small.box[0].neg_lo, small.box[0].hi);
    EXPECT_LE(hex(static_cast<double>(small.box[0].hi)).size(), 6U) << hex(small.box[0]);
}

}  // namespace
}  // namespace zeroset::test::kernel_inclusion_test
