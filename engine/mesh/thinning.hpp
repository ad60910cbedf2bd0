#pragma once

#include "engine/mesh/collapsible_mesh.hpp"
#include "engine/real/unbounded.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// The sum of squared distances from planes, weighted by area [GarlandHeckbert97].
struct Quadric {
    /// The upper half of the matrix: xx, xy, xz, yy, yz, zz.
    std::array<double, 6> a{};
    glm::dvec3 b{0.0};
    double c = 0.0;

    void add_plane(const glm::dvec3& normal, const glm::dvec3& point, double weight);
    void add(const Quadric& other);
    [[nodiscard]] double at(const glm::dvec3& p) const;
};

/// A vertex that goes into a neighbour.
struct Collapse {
    std::uint32_t from = 0, into = 0;
    float cost = unbounded_cost;

    static constexpr float unbounded_cost = 3e38F;
    [[nodiscard]] bool exists() const { return cost < unbounded_cost; }
};

/// A mesh with what each collapse of an edge costs and whether it keeps shapes and features.
/// Threads may work on it as on a CollapsibleMesh.
class Thinning {
public:
    Thinning(TriangleMesh mesh, double tolerance);

    [[nodiscard]] const CollapsibleMesh& mesh() const { return mesh_; }
    [[nodiscard]] TriangleMesh finish() { return mesh_.finish(); }

    /// The least cost of the collapses of `from`, whether they may be or not.
    [[nodiscard]] float least_cost(std::uint32_t from) const;
    /// The cheapest collapse of `from` that may be but for its distance from the surface.
    [[nodiscard]] Collapse best_collapse(std::uint32_t from) const;
    /// The triangles that are then about `collapse.into` in place of those about `from`.
    void new_triangles(const Collapse& collapse, std::vector<Triangle>& triangles) const;
    /// The middles of the new triangles and of their new sides.
    void add_middles(std::span<const Triangle> triangles, std::uint32_t into,
                     std::vector<glm::dvec3>& points) const;
    /// Points of the triangles, as close together as details were before; none where
    /// `add_middles` has them.
    void add_samples(std::span<const Triangle> triangles, std::vector<glm::dvec3>& points) const;
    void make(const Collapse& collapse);

private:
    [[nodiscard]] double cost_of(std::uint32_t from, std::uint32_t into) const;
    [[nodiscard]] bool is_same_place(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool is_flat(std::uint32_t from, std::uint32_t into) const;
    [[nodiscard]] bool keeps_features(std::uint32_t from, std::uint32_t into) const;
    [[nodiscard]] bool keeps_creases(std::uint32_t from, std::uint32_t into) const;
    [[nodiscard]] bool keeps_triangles(std::uint32_t from, std::uint32_t into) const;
    [[nodiscard]] bool keeps_normal(const Triangle& before, const Triangle& after) const;
    [[nodiscard]] bool is_crease(std::uint32_t a, std::uint32_t b) const;
    void crease_neighbours(std::uint32_t v, std::uint32_t without,
                           std::vector<std::uint32_t>& found) const;
    [[nodiscard]] int parts_of(const Triangle& triangle) const;
    [[nodiscard]] glm::dvec3 across(const Triangle& t) const {
        return area_vector(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]));
    }
    [[nodiscard]] double shape(const Triangle& t) const {
        return shape_of(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]));
    }

    CollapsibleMesh mesh_;
    double tolerance_;
    glm::dvec3 origin_{0.0};  ///< of the quadrics
    std::vector<Quadric> quadrics_;
    std::vector<float> detail_;  ///< the longest edge that was at a vertex
    /// Places of vertices of creases that went into each one.
    std::vector<std::vector<glm::dvec3>> lost_;
};

}  // namespace zeroset
