#pragma once

#include "engine/expr/expr.hpp"

#include <glm/glm.hpp>

namespace zeroset {

/// The function whose value at stretch * p is that of `f` at p: `f` in a world that is drawn
/// stretched (Camera). Of a parametric surface, a curve or a point, it in that world.
Expr stretched(const Expr& f, const glm::dvec3& stretch);

}  // namespace zeroset
