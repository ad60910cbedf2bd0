#pragma once

#include "engine/language/parse.hpp"
#include "engine/real/sleef.hpp"
#include "tests/support/compiled.hpp"
#include "tests/support/random_expression.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace zeroset::test {

/// Returns the vector widths, in floats, that machine code can use on this machine.
inline std::vector<int> machine_lanes() {
    std::vector<int> lanes{4, 8, 16};
    std::erase_if(lanes, [](int n) { return elementary_code(Elementary::Sin, n) == nullptr; });
    return lanes;
}

inline Expr parsed(std::string_view text) {
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << text << ": " << expr.error().reason;
        return operator_on_variables(op_info(Op::Add));
    }
    return *expr;
}

inline Kernel compiled(const Expr& expr, int lanes, bool with_double = false) {
    return test::compiled(expr, jit::CompileOptions{.lanes = lanes, .with_double = with_double});
}

}  // namespace zeroset::test
