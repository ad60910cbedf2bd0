#pragma once

#include "engine/mesh/triangle_mesh.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// A closed mesh whose edges can be collapsed: a vertex goes into a neighbour, with the two
/// triangles between them. Threads may collapse edges of vertices whose rings have no vertex in
/// common.
class CollapsibleMesh {
public:
    explicit CollapsibleMesh(TriangleMesh mesh);

    [[nodiscard]] std::size_t size() const { return mesh_.vertices.size(); }
    [[nodiscard]] std::size_t triangles() const { return alive_.load(std::memory_order_relaxed); }
    [[nodiscard]] const MeshVertex& vertex(std::uint32_t v) const { return mesh_.vertices[v]; }
    [[nodiscard]] const glm::dvec3& point(std::uint32_t v) const { return mesh_.vertices[v].point; }
    [[nodiscard]] const Triangle& triangle(std::uint32_t t) const { return mesh_.triangles[t]; }
    /// The triangles about a vertex; none: it is gone.
    [[nodiscard]] std::span<const std::uint32_t> star(std::uint32_t v) const { return stars_[v]; }
    /// The vertices beside `v`, counter-clockwise as seen from outside.
    void ring(std::uint32_t v, std::vector<std::uint32_t>& vertices) const;

    /// Whether the mesh stays closed and of the same topology if `from` goes into `into`, its
    /// neighbour: the link condition [Dey99].
    [[nodiscard]] bool may_collapse(std::uint32_t from, std::uint32_t into) const;
    /// Whether `from` may go into `into`, where the ring of `from` is known.
    [[nodiscard]] bool may_collapse(std::uint32_t from, std::uint32_t into,
                                    std::span<const std::uint32_t> ring_of_from) const;
    void collapse(std::uint32_t from, std::uint32_t into);
    /// Raises the kind of place that a vertex lies at.
    void raise_kind(std::uint32_t v, VertexKind kind);

    /// The mesh that is left, its vertices numbered anew.
    TriangleMesh finish();

private:
    TriangleMesh mesh_;
    std::vector<std::vector<std::uint32_t>> stars_;
    std::vector<std::uint8_t> dead_;
    std::atomic<std::size_t> alive_;  ///< triangles that are left
};

/// The vector across a triangle, twice its area long.
inline glm::dvec3 area_vector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::cross(b - a, c - a);
}

/// 1 for a triangle with equal sides, 0 for one without area.
double shape_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace zeroset
