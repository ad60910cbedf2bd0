#pragma once

#include "engine/mesh/triangle_mesh.hpp"
#include "engine/view/box.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// Counts and measures of a mesh.
struct MeshFacts {
    std::size_t vertices = 0, edges = 0, triangles = 0, components = 0;
    std::size_t open_edges = 0;  ///< with one triangle
    double area = 0.0;
    double volume = 0.0;  ///< of what a closed mesh encloses
    Box bounds{.lo = glm::dvec3(0.0), .hi = glm::dvec3(0.0)};

    /// V - E + F; of closed surfaces the sum of 2 - 2 genus.
    [[nodiscard]] long long euler() const {
        return static_cast<long long>(vertices) - static_cast<long long>(edges) +
               static_cast<long long>(triangles);
    }
    /// The genus of all components together.
    [[nodiscard]] long long genus() const {
        return (2 * static_cast<long long>(components) - euler()) / 2;
    }
};

MeshFacts facts_of(const TriangleMesh& mesh);
/// Counts alone, without sizes.
MeshFacts counts_of(const TriangleMesh& mesh);

/// One of the vertices of each vertex's component, the same one for all of it.
std::vector<std::uint32_t> components_of(const TriangleMesh& mesh);

}  // namespace zeroset
