#include "engine/interpret/interpret_code.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/real/processor.hpp"
#include "engine/real/rounding.hpp"
#include "engine/tape/tape.hpp"
#include "tests/support/kernel_batch.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace zeroset::interpret_code_test {
namespace {

/// The kernel with the functions of such registers in place of the machine's widest.
Kernel with_code(Kernel kernel, const InterpreterCode& code) {
    kernel.in_float.range.call = code.in_float.range;
    kernel.in_float.value.call = code.in_float.value;
    kernel.in_double.range.call = code.in_double.range;
    kernel.in_double.value.call = code.in_double.value;
    return kernel;
}

/// Values and ranges have the same bits in registers of any width.
TEST(InterpreterCode, IsTheSameInAllRegisters) {
    std::vector<const InterpreterCode*> others;
    if (machine_has_avx2_fma()) others.push_back(&interpreter_code_32());
    if (machine_has_avx512()) others.push_back(&interpreter_code_64());
    if (others.empty()) GTEST_SKIP() << "this machine has registers of 16 bytes only";
    test::RandomNumbers random(5);
    for (int i = 0; i < test::formulas_to_try(100); ++i) {
        const Expr f = test::random_expression(random, 1 + i % 6);
        const Kernel kernel = interpret(f);
        const test::KernelBatch batch(random, 2 * batch_multiple);
        const auto expected = batch.run(with_code(kernel, interpreter_code_16()));
        for (const InterpreterCode* code : others)
            ASSERT_EQ(batch.run(with_code(kernel, *code)), expected) << f.canonical();
    }
}

}  // namespace
}  // namespace zeroset::interpret_code_test
