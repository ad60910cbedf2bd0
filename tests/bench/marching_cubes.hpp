#pragma once

#include "engine/mesh/solid.hpp"
#include "engine/mesh/triangle_mesh.hpp"

namespace zeroset::test {

/// Plain marching cubes over `cells`^3 equal cubes of a box somewhat larger than the solid's, roots
/// by linear interpolation: what to compare with.
TriangleMesh marching_cubes(const MeshSolid& solid, int cells);

}  // namespace zeroset::test
