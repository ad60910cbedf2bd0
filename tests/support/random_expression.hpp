#pragma once

#include "engine/expr/expr.hpp"
#include "tests/support/random_numbers.hpp"

namespace zeroset::test {

/// A random graph of the operators of op.def and x, y, z, w, about `depth` operators deep (a
/// condition may be one deeper). All of it could come from the parser.
Expr random_expression(RandomNumbers& random, int depth);

/// The operator on x, y, z, with `n` where it has a number. For operands that are conditions, the
/// first is x < y, the second z <= x.
Expr operator_on_variables(const OpInfo& info, int n = 3);

}  // namespace zeroset::test
