#pragma once

#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/solid.hpp"
#include "engine/mesh/triangle_mesh.hpp"

#include <span>
#include <vector>

namespace zeroset {

/// About how far each triangle lies from the surface: the most that is measured, by value over
/// slope, in its middle and in the middles of its sides. +inf where the function is not defined.
std::vector<float> deviations(const MeshSolid& solid, const TriangleMesh& mesh,
                              const MeshWork& work);

}  // namespace zeroset
