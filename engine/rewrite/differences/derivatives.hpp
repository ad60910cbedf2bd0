#pragma once

#include "engine/expr/expr.hpp"

#include <array>

namespace zeroset {

// Formulas of the shape of f's level surfaces, exact: made of f's first and second derivatives by
// x, y and z. Undefined where f's gradient vanishes (but gradient_size) and where f is. They have
// f's parameters.

/// f's derivatives by x, y and z.
std::array<Expr, 3> gradient(const Expr& f);
/// The length of f's gradient.
Expr gradient_size(const Expr& f);
/// Half the divergence of the unit normal, which points to where f grows: 1/r on a sphere of radius
/// r inside of which f is below 0.
Expr mean_curvature(const Expr& f);
/// The product of the principal curvatures: 1/r^2 on a sphere of radius r.
Expr gaussian_curvature(const Expr& f);

}  // namespace zeroset
