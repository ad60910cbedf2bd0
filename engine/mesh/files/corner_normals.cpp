#include "engine/mesh/files/corner_normals.hpp"

#include <glm/glm.hpp>

namespace zeroset {
namespace {

glm::dvec3 unit(const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return length > 0 ? vector / length : glm::dvec3(0.0);
}

glm::dvec3 across(const TriangleMesh& mesh, const Triangle& t) {
    const glm::dvec3& a = mesh.vertices[t[0]].point;
    return glm::cross(mesh.vertices[t[1]].point - a, mesh.vertices[t[2]].point - a);
}

}  // namespace

glm::dvec3 face_normal(const TriangleMesh& mesh, const Triangle& triangle) {
    return unit(across(mesh, triangle));
}

glm::dvec3 corner_normal(const TriangleMesh& mesh, const Triangle& triangle, std::size_t k) {
    const MeshVertex& vertex = mesh.vertices[triangle[k]];
    return is_round(vertex) ? vertex.normal : face_normal(mesh, triangle);
}

std::vector<glm::dvec3> vertex_normals(const TriangleMesh& mesh) {
    std::vector<glm::dvec3> normals(mesh.vertices.size(), glm::dvec3(0.0));
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle)
            normals[v] += across(mesh, triangle);
    }
    for (std::size_t v = 0; v < normals.size(); ++v)
        normals[v] = is_round(mesh.vertices[v]) ? mesh.vertices[v].normal : unit(normals[v]);
    return normals;
}

}  // namespace zeroset
