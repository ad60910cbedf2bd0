#pragma once

#include "engine/mesh/triangle_mesh.hpp"

#include <expected>
#include <string>

namespace zeroset {

/// A closed mesh of all points that are at most half of `thickness` from an open or closed surface
/// along its normals, with a rim where it ends. An error, one line, where the surface has edges,
/// bends more than that, or comes so near to itself; `tolerance`: how exactly that is looked at.
std::expected<TriangleMesh, std::string> wall_of(const TriangleMesh& surface, double thickness,
                                                 double tolerance);

}  // namespace zeroset
