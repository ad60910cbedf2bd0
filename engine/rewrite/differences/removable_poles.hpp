#pragma once

#include "engine/expr/expr.hpp"

#include <optional>

namespace zeroset {

/// Gives the function its limits where quotients are 0/0 and have one: sin(a)/a is sinc(a),
/// (f(x) - f(y))/(x - y) the divided difference of f, (1 - cos x)/x^2 is sinc(x/2)^2/2, also where
/// both are 0. Quotients whose numerator is not proved to be 0 with the divisor stay, and so do
/// those of a common factor, as x y/(x z). Nothing where no quotient is written otherwise.
std::optional<Expr> without_removable_poles(const Expr& expr);

}  // namespace zeroset
