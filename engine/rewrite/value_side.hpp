#pragma once

#include "engine/expr/expr.hpp"

namespace zeroset {

/// The function whose level a surface f = 0 is: g where f is g - c or c - g, as g = c is read, for
/// a c without x, y and z; else f itself. Without restrictions (unrestricted.hpp) of f: it is asked
/// for only where they hold.
Expr value_side(const Expr& f);

}  // namespace zeroset
