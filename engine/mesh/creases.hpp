#pragma once

#include "engine/mesh/contour.hpp"
#include "engine/mesh/mesh_work.hpp"

namespace zeroset {

/// Moves the contour's vertices near edges of the solid onto them, by Newton's method for the two
/// parts that meet there; those that would go farther than a step of the lattice or so stay. In
/// upward rounding.
void sharpen_creases(const MeshSolid& solid, double step, Contour& contour, const MeshWork& work);

}  // namespace zeroset
