#pragma once

#include "engine/expr/expr.hpp"
#include "engine/expr/kernel.hpp"
#include "engine/num/dual.hpp"

#include <array>

namespace zeroset {

/// The reference kernel: evaluates the graph lane by lane in C++. Bit-equal to the JIT's.
Kernel interpret(const Expr& expr);

/// f and its gradient in double at (x, y, z, w), not rounded outward; parameters are 1.
Dual<double> value_at(const Expr& expr, const std::array<double, 4>& at);

/// What every maker of kernels fills in from the graph.
Kernel kernel_without_code(const Expr& expr);

}  // namespace zeroset
