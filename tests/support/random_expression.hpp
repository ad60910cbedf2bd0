#pragma once

#include "engine/expr/expr.hpp"
#include "tests/support/random_numbers.hpp"

namespace zeroset::test {

/// A graph of every operator of op.def and x, y, z, w, at most `depth` operators deep. All of it
/// could have been parsed.
Expr random_expression(RandomNumbers& random, int depth);

/// The operator on x (and y), with the exponent `n` for IntPower.
Expr operator_on_variables(const OpInfo& info, int n = 3);

}  // namespace zeroset::test
