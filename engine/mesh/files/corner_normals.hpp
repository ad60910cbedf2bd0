#pragma once

#include "engine/mesh/triangle_mesh.hpp"

#include <vector>

namespace zeroset {

/// The vector across a triangle, of length 1, outward; 0 where it has no area.
glm::dvec3 face_normal(const TriangleMesh& mesh, const Triangle& triangle);

/// Whether the vertex has one normal, and not one for each side of an edge.
inline bool is_round(const MeshVertex& vertex) {
    return vertex.kind == VertexKind::Smooth && vertex.normal != glm::dvec3(0.0);
}

/// The normal of corner k of a triangle: the surface's, at edges that of the triangle.
glm::dvec3 corner_normal(const TriangleMesh& mesh, const Triangle& triangle, std::size_t k);

/// A normal for each vertex; at edges the mean of the triangles' by their areas.
std::vector<glm::dvec3> vertex_normals(const TriangleMesh& mesh);

}  // namespace zeroset
