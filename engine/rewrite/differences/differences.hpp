#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

/// Returns the same function, its small differences without cancellation: in (F(x + c) - F(x))/c,
/// which many formulas have for a derivative, both terms are computed to their own accuracy and
/// enclosed on their own, and the difference of the enclosures is divided by a small c. It is
/// written by what is common to both instead: (x + c)^2 - x^2 is c (2x + c), sin(u) - sin(v) is (u
/// - v) cos((u + v)/2) sinc((u - v)/2). Differences whose terms differ by more than constants are
/// left alone, and so are those of large c.
Expr without_small_differences(const Expr& expr);

}  // namespace zeroset
