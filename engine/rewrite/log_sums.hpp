#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

/// Returns the same function, with LogSum for logarithms of sums of exponentials, as smooth minima
/// are made of: ln(exp(-k a) + exp(-k b)). The exponentials of large operands overflow, and their
/// enclosures are far wider than what the logarithm makes of them.
Expr with_log_sums(const Expr& expr);

}  // namespace zeroset
