#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

/// Returns the same function, its angles from lengths taken by atan2, whose slope has no end:
/// acos(a / r) is atan2(sqrt(T), a) where r is sqrt(a^2 + T) and T a sum of squares, and asin(a /
/// r) is atan2(a, sqrt(T)). Both are undefined where r is 0.
Expr plain_angles(const Expr& expr);

/// Returns the same function, with Length for square roots of sums of squares, and AngleSin and
/// AngleCos for sines and cosines of whole multiples of angles.
Expr polar_form(const Expr& expr);

}  // namespace zeroset
