#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

/// Puts SmoothMin in place of quadratic smooth minima and maxima of constant width, as
/// min(a, b) - h^2/(4k) with h = max(k - |a - b|, 0); the values stay. Its enclosure is tight,
/// where that of the difference is wider the more often it is nested.
Expr with_smooth_minima(const Expr& expr);

}  // namespace zeroset
