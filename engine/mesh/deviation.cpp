#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/mesh_steps.hpp"

#include <algorithm>

namespace zeroset {

std::vector<float> deviations(const MeshSolid& solid, const TriangleMesh& mesh,
                              const MeshWork& work) {
    constexpr std::size_t samples = 4;
    std::vector<glm::dvec3> points;
    points.reserve(samples * mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        const glm::dvec3& a = mesh.vertices[triangle[0]].point;
        const glm::dvec3& b = mesh.vertices[triangle[1]].point;
        const glm::dvec3& c = mesh.vertices[triangle[2]].point;
        points.insert(points.end(),
                      {(a + b + c) / 3.0, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)});
    }
    const std::vector<SolidValue> values = field_at(solid, points, work, Normals::Without);
    std::vector<float> farthest(mesh.triangles.size());
    for (std::size_t i = 0; i < farthest.size(); ++i) {
        double far = 0.0;
        for (std::size_t k = 0; k < samples; ++k)
            far = std::max(far, values[samples * i + k].distance());
        farthest[i] = static_cast<float>(far);
    }
    return farthest;
}

}  // namespace zeroset
