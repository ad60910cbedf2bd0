#pragma once

#include "engine/expr/expr.hpp"
#include "tests/support/random_numbers.hpp"

namespace zeroset::test {

/// A graph of every operator of op.def and x, y, z, w, about `depth` operators deep (a condition
/// may be one deeper). All of it could have been parsed.
Expr random_expression(RandomNumbers& random, int depth);

/// The operator on x, y, z, with `n` where it has a number. Operands that are conditions are
/// x < y as the first, z <= x as the second.
Expr operator_on_variables(const OpInfo& info, int n = 3);

/// How many random formulas a test tries: ZEROSET_FORMULAS in the environment, else `usual`.
int formulas_to_try(int usual);

}  // namespace zeroset::test
