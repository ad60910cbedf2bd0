#pragma once

#include "engine/expr/expr.hpp"

// Conditions written by as few comparisons as they need: people write the cells of a lattice as
// sums of if(abs(x - 2/3) < 1/9, 1, 0) and ask whether the sum is 0.

namespace zeroset {

/// Returns the same function, also where it is defined. Comparisons with constants lose what is
/// added to the other side, its factors, its absolute values and the choices and sums of whole
/// numbers in it; conditions that are always true or never are left out, products of choices of 1
/// and 0 are one choice.
Expr with_plain_conditions(const Expr& expr);

}  // namespace zeroset
