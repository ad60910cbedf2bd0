#include "engine/mesh/collapsible_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace zeroset {
namespace {

bool has(const Triangle& triangle, std::uint32_t vertex) {
    return std::ranges::find(triangle, vertex) != triangle.end();
}

}  // namespace

CollapsibleMesh::CollapsibleMesh(TriangleMesh mesh)
    : mesh_(std::move(mesh)),
      stars_(mesh_.vertices.size()),
      dead_(mesh_.triangles.size()),
      alive_(mesh_.triangles.size()) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        for (const std::uint32_t v : mesh_.triangles[t])
            stars_[v].push_back(t);
    }
}

void CollapsibleMesh::ring(std::uint32_t v, std::vector<std::uint32_t>& vertices) const {
    vertices.clear();
    for (const std::uint32_t t : stars_[v]) {
        for (const std::uint32_t other : mesh_.triangles[t]) {
            if (other != v && std::ranges::find(vertices, other) == vertices.end())
                vertices.push_back(other);
        }
    }
}

bool CollapsibleMesh::may_collapse(std::uint32_t from, std::uint32_t into) const {
    std::vector<std::uint32_t> own;
    ring(from, own);
    return may_collapse(from, into, own);
}

bool CollapsibleMesh::may_collapse(std::uint32_t from, std::uint32_t into,
                                   std::span<const std::uint32_t> ring_of_from) const {
    // A vertex beside both is in two triangles about `into`; the two triangles between them have
    // two.
    int common = 0;
    for (const std::uint32_t t : stars_[into]) {
        for (const std::uint32_t v : mesh_.triangles[t]) {
            if (v == into || v == from) continue;
            if (std::ranges::find(ring_of_from, v) != ring_of_from.end()) ++common;
        }
    }
    if (common != 4) return false;
    std::array<std::uint32_t, 2> both{};
    std::size_t count = 0;
    for (const std::uint32_t t : stars_[from]) {
        const Triangle& triangle = mesh_.triangles[t];
        if (!has(triangle, into)) continue;
        if (count == both.size()) return false;
        for (const std::uint32_t v : triangle) {
            if (v != from && v != into) both.at(count) = v;
        }
        ++count;
    }
    if (count != both.size()) return false;
    // The ends of the two triangles must not be joined by a triangle of each vertex: a tetrahedron.
    const auto joined = [&](std::uint32_t v) {
        return std::ranges::any_of(stars_[v], [&](std::uint32_t t) {
            return has(mesh_.triangles[t], both[0]) && has(mesh_.triangles[t], both[1]);
        });
    };
    return !(joined(from) && joined(into));
}

void CollapsibleMesh::changes(std::uint32_t from, std::uint32_t into,
                              std::vector<Change>& changed) const {
    changed.clear();
    for (const std::uint32_t t : stars_[from]) {
        const Triangle& before = mesh_.triangles[t];
        if (has(before, into)) continue;
        Change change{.before = before, .after = before};
        std::ranges::replace(change.after, from, into);
        changed.push_back(change);
    }
}

void CollapsibleMesh::collapse(std::uint32_t from, std::uint32_t into) {
    for (const std::uint32_t t : std::exchange(stars_[from], {})) {
        Triangle& triangle = mesh_.triangles[t];
        if (has(triangle, into)) {
            dead_[t] = true;
            --alive_;
            for (const std::uint32_t v : triangle)
                std::erase(stars_[v], t);
        } else {
            std::ranges::replace(triangle, from, into);
            stars_[into].push_back(t);
        }
    }
}

TriangleMesh CollapsibleMesh::finish() {
    std::vector<std::uint32_t> numbers(mesh_.vertices.size());
    TriangleMesh result;
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
        if (stars_[v].empty()) continue;
        numbers[v] = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh_.vertices[v]);
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        if (dead_[t]) continue;
        const Triangle& old = mesh_.triangles[t];
        result.triangles.push_back({numbers[old[0]], numbers[old[1]], numbers[old[2]]});
    }
    return result;
}

glm::dvec3 area_vector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::cross(b - a, c - a);
}

double shape_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 bc = c - b;
    const glm::dvec3 ca = a - c;
    const double squares = glm::dot(ab, ab) + glm::dot(bc, bc) + glm::dot(ca, ca);
    constexpr double of_equal_sides = 3.4641016151377544;  // 2 sqrt(3)
    return squares > 0 ? of_equal_sides * glm::length(area_vector(a, b, c)) / squares : 0.0;
}

}  // namespace zeroset
