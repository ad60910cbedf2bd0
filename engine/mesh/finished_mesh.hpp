#pragma once

#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/solid.hpp"
#include "engine/mesh/triangle_mesh.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Changes and measures of finished triangles. Each has a source of its own.

namespace zeroset {

/// Takes out the triangles of cuts and of bounds, so that the surface is left as it is, open where
/// they end it. In upward rounding.
void keep_surface(TriangleMesh& mesh, const MeshSolid& solid);

/// Takes out vertices that no triangle has.
void drop_unused(TriangleMesh& mesh);

/// Makes no two vertices have the same numbers in a file of 32-bit numbers, `scales` of them to a
/// unit, so that the mesh stays closed for readers that join equal points. Moves vertices by some
/// last digits of these numbers at most. Returns which vertices are left, in their order.
std::vector<std::uint32_t> make_numbers_different(TriangleMesh& mesh,
                                                  std::span<const double> scales);

/// The thinnest place that was found in a closed mesh.
struct SmallestWall {
    double thickness = 0.0;  ///< world units
    glm::dvec3 at{0.0};      ///< the middle between its two sides
    std::size_t places = 0;  ///< where it was looked for
    /// The thickness that walls have where their sides are about parallel, as they are where a wall
    /// is thinnest, but for a hundredth of their area: without sharp rims. Nothing: there is none.
    std::optional<double> but_for_rims = std::nullopt;
};

/// Looks for it straight inwards from triangles, from their middles and near their corners, to
/// where that way leaves the solid; a wall is there if the side met faces the other way within 60
/// degrees. So edges of less than 60 degrees have no thickness, and walls between the places that
/// are asked may be thinner, by what they change from one triangle to the next. Nothing: there is
/// no such place, or the time did not suffice.
std::optional<SmallestWall> smallest_wall(const TriangleMesh& mesh, const MeshWork& work);

/// A closed mesh of all points that are at most half of `thickness` from an open or closed surface
/// along its normals, with a rim where it ends. An error, one line, where the surface has edges,
/// bends more than that, or comes so near to itself; `tolerance`: how exactly that is looked at.
std::expected<TriangleMesh, std::string> wall_of(const TriangleMesh& surface, double thickness,
                                                 double tolerance);

}  // namespace zeroset
