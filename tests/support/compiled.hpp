#pragma once

#include "engine/interpret/interpret.hpp"
#include "jit/compile.hpp"

#include <gtest/gtest.h>

namespace zeroset::test {

/// The graph's machine code. Where there is none, the test fails and the interpreter is returned.
inline Kernel compiled(const Expr& expr, const jit::CompileOptions& options) {
    auto kernel = jit::compile(expr, options);
    if (kernel) return *kernel;
    ADD_FAILURE() << kernel.error().message;
    return interpret(expr);
}

}  // namespace zeroset::test
