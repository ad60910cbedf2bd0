#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

/// The same function, to the last bit of its values, with min, max, if and where moved out of
/// negations, and of sums, products and quotients with what depends on no choice, where each is
/// used once: -min(a, b) + c becomes max(-a + c, -b + c). What is left between choices and parts
/// (engine/expr/parts.hpp) needs no interpreter.
Expr with_outer_choices(const Expr& expr);

}  // namespace zeroset
