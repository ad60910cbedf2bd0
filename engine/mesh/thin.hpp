#pragma once

#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/solid.hpp"
#include "engine/mesh/triangle_mesh.hpp"

#include <cstddef>

namespace zeroset {

struct ThinOptions {
    double tolerance = 0.0;  ///< new triangles are measured to be no farther from the surface
    std::size_t most_triangles = 0;  ///< ends the work where so many are left; 0: as few as can be
    MeshWork work = {};
};

/// Collapses edges of a closed mesh while the tolerance holds, those that change it least first
/// [GarlandHeckbert97]. Vertices stay where they are, on the surface; those of creases go along
/// them only, corners stay. Topology does not change. In upward rounding.
void thin(TriangleMesh& mesh, const MeshSolid& solid, const ThinOptions& options);

}  // namespace zeroset
