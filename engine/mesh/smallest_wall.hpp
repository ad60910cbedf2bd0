#pragma once

#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/triangle_mesh.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>

namespace zeroset {

/// The thinnest place that was found in a closed mesh.
struct SmallestWall {
    double thickness = 0.0;  ///< world units
    glm::dvec3 at{0.0};      ///< the middle between its two sides
    std::size_t places = 0;  ///< where it was looked for
};

/// Looks for it straight inwards from triangles, from their middles and near their corners, to
/// where that way leaves the solid; a wall is there if the side met faces the other way within 60
/// degrees. So edges of less than 60 degrees have no thickness, and walls between the places that
/// are asked may be thinner, by what they change from one triangle to the next. Nothing: there is
/// no such place.
std::optional<SmallestWall> smallest_wall(const TriangleMesh& mesh, const MeshWork& work);

}  // namespace zeroset
