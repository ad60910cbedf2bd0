#include "engine/mesh/collapsible_mesh.hpp"

#include <algorithm>
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
    std::vector<std::uint32_t> counts(mesh_.vertices.size());
    for (const Triangle& triangle : mesh_.triangles) {
        for (const std::uint32_t v : triangle)
            ++counts[v];
    }
    for (std::size_t v = 0; v < counts.size(); ++v)
        stars_[v].reserve(counts[v] + 4);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        for (const std::uint32_t v : mesh_.triangles[t])
            stars_[v].push_back(t);
    }
}

void CollapsibleMesh::ring(std::uint32_t v, std::vector<std::uint32_t>& vertices) const {
    vertices.clear();
    const std::vector<std::uint32_t>& star = stars_[v];
    if (star.empty()) return;
    const auto corner_of = [&](const Triangle& t) { return t[0] == v ? 0U : t[1] == v ? 1U : 2U; };
    const Triangle& first = mesh_.triangles[star.front()];
    std::uint32_t at = first[(corner_of(first) + 1) % 3];
    for (std::size_t i = 0; i < star.size(); ++i) {
        vertices.push_back(at);
        for (const std::uint32_t t : star) {
            const Triangle& triangle = mesh_.triangles[t];
            const std::uint32_t k = corner_of(triangle);
            if (triangle[(k + 1) % 3] != at) continue;
            at = triangle[(k + 2) % 3];
            break;
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
    // A vertex beside both is in two triangles about `into`; the two triangles between the ends
    // have two such vertices.
    int common = 0;
    for (const std::uint32_t t : stars_[into]) {
        for (const std::uint32_t v : mesh_.triangles[t]) {
            if (v == into || v == from) continue;
            if (std::ranges::find(ring_of_from, v) != ring_of_from.end()) ++common;
        }
    }
    if (common != 4) return false;
    // Where three triangles are about each of them, all belongs to a tetrahedron.
    return stars_[from].size() > 3 || stars_[into].size() > 3;
}

void CollapsibleMesh::collapse(std::uint32_t from, std::uint32_t into) {
    for (const std::uint32_t t : std::exchange(stars_[from], {})) {
        Triangle& triangle = mesh_.triangles[t];
        if (has(triangle, into)) {
            dead_[t] = 1;
            alive_.fetch_sub(1, std::memory_order_relaxed);
            for (const std::uint32_t v : triangle)
                std::erase(stars_[v], t);
        } else {
            std::ranges::replace(triangle, from, into);
            stars_[into].push_back(t);
        }
    }
}

void CollapsibleMesh::raise_kind(std::uint32_t v, VertexKind kind) {
    mesh_.vertices[v].kind = std::max(mesh_.vertices[v].kind, kind);
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
        if (dead_[t] != 0) continue;
        const Triangle& old = mesh_.triangles[t];
        result.triangles.push_back({numbers[old[0]], numbers[old[1]], numbers[old[2]]});
    }
    return result;
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
