#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/num/dual.hpp"
#include "engine/tape/parts.hpp"

#include <array>
#include <span>
#include <vector>

namespace zeroset {

/// The reference kernel, in float and double: evaluates the graph block by block in C++. Bit-equal
/// to the JIT's.
Kernel interpret(const Expr& expr);

/// The reference kernel where parts of the graph have code of their own. `facts` are the graph's.
Kernel interpret(const Expr& expr, std::vector<Facts> facts, Parts parts);

/// The values alone, bit-equal to the JIT's.
PointFunction interpret_points(const Expr& expr);

/// f and its gradient in double at (x, y, z, w), not rounded outward; parameters that are not given
/// are 1.
Dual<double> value_at(const Expr& expr, const std::array<double, 4>& at,
                      std::span<const double> parameters = {});

}  // namespace zeroset
