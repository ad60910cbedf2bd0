#include "tests/oracle/form_inclusion.hpp"

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

#include <cstdint>
#include <cstdio>

// Checks of form kernels of random formulas against MPFI; `inclusion_checks --forms 1` makes many
// more of them.

namespace zeroset::test::form_inclusion_test {
namespace {

Kernel machine_code(const Expr& expr) { return compiled(expr, {.with_double = true}); }

template <class Real>
class FormInclusion : public ::testing::Test {
protected:
    /// Returns the operators in the formulas that were tried.
    static std::set<Op> check(MakeKernel make, int formulas, int batches, std::uint64_t seed) {
        RandomNumbers random(seed);
        InclusionTally tally;
        for (int i = 0; i < formulas && tally.failures == 0; ++i)
            check_forms<Real>(make, 1 + i % 6, batches, random, tally);
        EXPECT_EQ(tally.failures, 0U) << tally.first;
        if (tally.failures > 0) return tally.operators;
        const auto cells = static_cast<std::uint64_t>(formulas * batches) * cells_a_batch;
        EXPECT_GT(tally.checks, 3 * cells);
        std::printf("checked %llu claims\n", static_cast<unsigned long long>(tally.checks));
        return tally.operators;
    }

    static void check_one(const char* text, int batches, std::uint64_t seed) {
        const Expr expr = parse(text).value();
        check_kernel(interpret(expr), expr, batches, seed);
    }
    static void check_pieces(const char* text, int batches, std::uint64_t seed) {
        const Expr expr = parse(text).value();
        check_kernel(by_pieces(interpret(expr)), expr, batches, seed);
        check_kernel(by_pieces(machine_code(expr)), expr, batches, seed + 1);
    }
    static void check_kernel(const Kernel& kernel, const Expr& expr, int batches,
                             std::uint64_t seed) {
        RandomNumbers random(seed);
        InclusionTally tally;
        for (int i = 0; i < batches; ++i)
            ASSERT_EQ(disproved(kernel, expr, random_cells<Real>(random), tally), "");
        EXPECT_GT(tally.checks, static_cast<std::uint64_t>(batches) * cells_a_batch);
    }
};
TYPED_TEST_SUITE(FormInclusion, RealTypes, RealTypeNames);

TYPED_TEST(FormInclusion, OfTheInterpreterHolds) {
    EXPECT_EQ(missing_operators(this->check(interpret, formulas_to_try(70), 2, 21)), "");
}
TYPED_TEST(FormInclusion, OfPartsHolds) {
    this->check(interpret_with_parts, formulas_to_try(25), 2, 23);
}
TYPED_TEST(FormInclusion, OfMachineCodeHolds) {
    this->check(machine_code, formulas_to_try(6), 10, 22);
}
TYPED_TEST(FormInclusion, OfPiecesHolds) {
    this->check([](const Expr& expr) { return by_pieces(interpret(expr)); }, formulas_to_try(50), 2,
                26);
}
TYPED_TEST(FormInclusion, OfPiecesInMachineCodeHolds) {
    this->check([](const Expr& expr) { return by_pieces(machine_code(expr)); }, formulas_to_try(5),
                10, 27);
}

/// Most forms cover their roundings by bounds of their own; these rely on upward rounding.
TYPED_TEST(FormInclusion, OfStepsHolds) {
    this->check_one("mod(x, w)", 150, 24);
    this->check_one("abs(w)", 150, 25);
}

/// Forms of estimates of distances, which choose between steps that may be beyond the floats.
TYPED_TEST(FormInclusion, OfEstimatesOfDistancesHolds) {
    this->check_one(
        "distance_estimate(q, 4, (x, y, z, 0), quaternion_square(q) + (-0.2, 0.8, 0, 0))", 10, 29);
    for (const char* const text :
         {"distance_estimate(q, 1, (x, y, z, 0), quaternion_square(q) + (-0.2, 0.8, w, 0))",
          "distance_estimate(u, 5, x + y/3, u^3 - z)"}) {
        this->check_one(text, 10, 31);
        this->check_pieces(text, 2, 30);
    }
}

/// Checks cells across jumps, where pieces tell most.
TYPED_TEST(FormInclusion, OfPiecesBesideJumpsHolds) {
    for (const char* const text :
         {"floor(x) + y", "ceil(3*x)*y", "round(x + y)", "sign(x)*y + sign(y)", "mod(x, 2)*z",
          "mod(mod(3*x, 2) + y, 0.7)", "if(x < y, z, x*y)", "atan2(y, x)", "atan2(x*y, z)*w",
          "if(floor(x) < mod(y, 1), atan2(y, x), z)", "where(x, floor(y) <= 0)"}) {
        this->check_pieces(text, 15, 28);
    }
}

}  // namespace
}  // namespace zeroset::test::form_inclusion_test
