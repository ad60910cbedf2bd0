#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

/// Returns the same function with min, max, if and where moved out of negations, of sums with what
/// depends on no choice, and of multiples, where each is used once: -min(a, b) + c becomes max(-a +
/// c, -b + c), so that less is left between choices and parts (engine/tape/parts.hpp). Values are
/// rounded as before, but for constants that come together.
Expr with_outer_choices(const Expr& expr);

}  // namespace zeroset
