#include "engine/mesh/open_surface.hpp"

#include "engine/mesh/field_at_points.hpp"

#include <utility>

namespace zeroset {

void drop_unused(TriangleMesh& mesh) {
    constexpr std::uint32_t unused = ~std::uint32_t{0};
    std::vector<std::uint32_t> numbers(mesh.vertices.size(), unused);
    std::vector<MeshVertex> kept;
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& v : triangle) {
            if (numbers[v] == unused) {
                numbers[v] = static_cast<std::uint32_t>(kept.size());
                kept.push_back(mesh.vertices[v]);
            }
            v = numbers[v];
        }
    }
    mesh.vertices = std::move(kept);
}

void keep_surface(TriangleMesh& mesh, const MeshSolid& solid, int threads) {
    std::vector<glm::dvec3> middles;
    middles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        middles.push_back(
            (mesh.vertices[t[0]].point + mesh.vertices[t[1]].point + mesh.vertices[t[2]].point) /
            3.0);
    }
    const std::vector<FieldValue> values = field_at(solid, middles, threads);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (values[i].part < solid.surface_parts) mesh.triangles[kept++] = mesh.triangles[i];
    }
    mesh.triangles.resize(kept);
    drop_unused(mesh);
}

}  // namespace zeroset
