#include "engine/mesh/feature_point.hpp"
#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/mesh_steps.hpp"

#include <algorithm>

namespace zeroset {
namespace {

/// The nearest edge of a triangle at each vertex: how far a vertex may go without turning one over.
std::vector<double> shortest_edges(const TriangleMesh& mesh) {
    std::vector<double> shortest(mesh.vertices.size(), 1e300);
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            const double length = glm::distance(mesh.vertices[a].point, mesh.vertices[b].point);
            shortest[a] = std::min(shortest[a], length);
            shortest[b] = std::min(shortest[b], length);
        }
    }
    return shortest;
}

}  // namespace

void sharpen_creases(const MeshSolid& solid, double step, Contour& contour, const MeshWork& work) {
    constexpr int most_steps = 4;
    const std::vector<double> room = shortest_edges(contour.mesh);
    std::vector<glm::dvec3> points;
    points.reserve(contour.creases.size());
    for (const Contour::Crease& crease : contour.creases)
        points.push_back(contour.mesh.vertices[crease.vertex].point);
    for (int i = 0; i < most_steps; ++i) {
        std::vector<PartPlace> places;
        for (std::size_t c = 0; c < points.size(); ++c) {
            for (const std::uint32_t part : contour.creases[c].parts)
                places.push_back({.part = part, .point = points[c]});
        }
        const std::vector<SolidValue> values = parts_at(solid, places);
        for (std::size_t c = 0; c < points.size(); ++c) {
            std::vector<FeatureSide> sides;
            for (const std::size_t k : {2 * c, 2 * c + 1}) {
                const SolidValue& value = values[k];
                sides.push_back({.base = points[c],
                                 .point = points[c] - value.level * value.normal,
                                 .normal = value.normal});
            }
            points[c] = meeting_point(sides, points[c]).value_or(points[c]);
        }
    }
    const std::vector<SolidValue> values = field_at(solid, points, work);
    for (std::size_t c = 0; c < points.size(); ++c) {
        const std::uint32_t v = contour.creases[c].vertex;
        MeshVertex& vertex = contour.mesh.vertices[v];
        const bool near =
            glm::distance(points[c], vertex.point) < std::max(0.5 * room[v], 0.01 * step);
        if (near && values[c].distance() < 1e-6 * step) vertex.point = points[c];
    }
}

}  // namespace zeroset
