#pragma once

#include "engine/mesh/triangle_mesh.hpp"

#include <string>

namespace zeroset::test {

/// The defect of a mesh that is to be closed: an edge without exactly two triangles that run along
/// it in opposite directions, a vertex whose triangles are not one ring, a triangle without three
/// vertices, one that is there twice, a vertex of no triangle. Empty: none.
std::string defect_of(const TriangleMesh& mesh);

/// V - E + F, counted apart from the engine's own.
long long euler_characteristic(const TriangleMesh& mesh);

/// The enclosed volume by the divergence theorem: above 0 where triangles face outwards.
double enclosed_volume(const TriangleMesh& mesh);

}  // namespace zeroset::test
