#pragma once

#include "engine/expr/expr.hpp"
#include "engine/expr/kernel.hpp"
#include "engine/num/dual.hpp"

#include <array>
#include <span>

namespace zeroset {

/// The reference kernel, in float and double: evaluates the graph block by block in C++. Bit-equal
/// to the JIT's.
Kernel interpret(const Expr& expr);

/// f and its gradient in double at (x, y, z, w), not rounded outward; parameters that are not given
/// are 1.
Dual<double> value_at(const Expr& expr, const std::array<double, 4>& at,
                      std::span<const double> parameters = {});

}  // namespace zeroset
