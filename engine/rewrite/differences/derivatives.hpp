#pragma once

#include "engine/expr/expr.hpp"

#include <array>
#include <span>
#include <vector>

namespace zeroset {

// f's derivatives as formulas, exact. They have f's parameters.

/// The derivatives by x, y and z.
std::array<Expr, 3> gradient_of(const Expr& f);
/// The derivatives by x, y and z of some nodes of a builder, as nodes of it; those of what several
/// are made of are made once.
std::vector<std::array<NodeId, 3>> gradients_in(ExprBuilder& builder,
                                                std::span<const NodeId> roots);
/// The derivative on the lines through a point: dot(f's gradient, (x, y, z) - point). 0 where such
/// a line touches a level surface of f.
Expr slope_from(const Expr& f, const std::array<double, 3>& point);
/// The derivative along a direction of any length.
Expr slope_along(const Expr& f, const std::array<double, 3>& direction);

// Formulas of the shape of f's level surfaces, exact: made of f's first and second derivatives by
// x, y and z. Undefined where f's gradient vanishes (but gradient_size) and where f is. They have
// f's parameters.

/// The length of f's gradient.
Expr gradient_size(const Expr& f);
/// Half the divergence of the unit normal, which points to where f grows: 1/r on a sphere of radius
/// r inside of which f is below 0.
Expr mean_curvature(const Expr& f);
/// The product of the principal curvatures: 1/r^2 on a sphere of radius r.
Expr gaussian_curvature(const Expr& f);

}  // namespace zeroset
