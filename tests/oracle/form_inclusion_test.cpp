#include "tests/oracle/form_inclusion.hpp"

#include "engine/expr/interpret.hpp"
#include "engine/expr/parse.hpp"
#include "tests/support/compiled.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>

// Form kernels of random formulas against MPFI; `inclusion_checks --forms 1` makes many more of
// these checks.

namespace zeroset::test {
namespace {

Kernel machine_code(const Expr& expr) { return compiled(expr, {.with_double = true}); }

template <class Real>
class FormInclusion : public ::testing::Test {
protected:
    static void check(MakeKernel make, int formulas, int batches, std::uint64_t seed) {
        RandomNumbers random(seed);
        InclusionTally tally;
        for (int i = 0; i < formulas && tally.failures == 0; ++i)
            check_forms<Real>(make, 1 + i % 6, batches, random, tally);
        ASSERT_EQ(tally.failures, 0U) << tally.first;
        const auto cells = static_cast<std::uint64_t>(formulas * batches) * cells_a_batch;
        EXPECT_GT(tally.checks, 3 * cells);
        std::printf("checked %llu claims\n", static_cast<unsigned long long>(tally.checks));
    }

    static void check_one(const char* text, int batches, std::uint64_t seed) {
        const Expr expr = parse(text).value();
        const Kernel kernel = interpret(expr);
        RandomNumbers random(seed);
        InclusionTally tally;
        for (int i = 0; i < batches; ++i)
            ASSERT_EQ(disproved(kernel, expr, random_cells<Real>(random), tally), "");
        EXPECT_GT(tally.checks, static_cast<std::uint64_t>(batches) * cells_a_batch);
    }
};
TYPED_TEST_SUITE(FormInclusion, RealTypes, RealTypeNames);

TYPED_TEST(FormInclusion, OfTheInterpreterHolds) { this->check(interpret, 400, 2, 21); }
TYPED_TEST(FormInclusion, OfPartsHolds) { this->check(interpret_with_parts, 200, 2, 23); }
TYPED_TEST(FormInclusion, OfMachineCodeHolds) { this->check(machine_code, 20, 10, 22); }

/// Bounds of their own cover the roundings of most forms; these rely on upward rounding.
TYPED_TEST(FormInclusion, OfStepsHolds) {
    this->check_one("mod(x, w)", 500, 24);
    this->check_one("abs(w)", 500, 25);
}

}  // namespace
}  // namespace zeroset::test
