#pragma once

#include "engine/mesh/solid.hpp"
#include "engine/mesh/triangle_mesh.hpp"

namespace zeroset {

/// Takes out the triangles of cuts and of bounds, so that the surface is left as it is, open where
/// they end it. In upward rounding.
void keep_surface(TriangleMesh& mesh, const MeshSolid& solid);

/// Takes out vertices that no triangle has.
void drop_unused(TriangleMesh& mesh);

}  // namespace zeroset
