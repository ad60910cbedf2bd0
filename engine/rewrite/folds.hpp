#pragma once

#include "engine/expr/expr.hpp"

// People repeat shapes by abs(mod(x, d) - d/2) and (mod(x, d) - d/2)^2, where the jumps of mod make
// no jump.

namespace zeroset {

/// Returns the same function with the continuous Op::Fold in place of such remainders.
Expr with_folds(const Expr& expr);

}  // namespace zeroset
