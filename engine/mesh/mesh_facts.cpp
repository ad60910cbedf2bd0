#include "engine/mesh/mesh_facts.hpp"

#include "engine/mesh/place_index.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace zeroset {
namespace {

/// Groups of vertices that triangles join.
class Groups {
public:
    explicit Groups(const TriangleMesh& mesh) : parents_(mesh.vertices.size()) {
        std::iota(parents_.begin(), parents_.end(), 0U);
        for (const Triangle& t : mesh.triangles) {
            join(t[0], t[1]);
            join(t[1], t[2]);
        }
    }
    std::uint32_t root(std::uint32_t v) {
        while (parents_[v] != v)
            v = parents_[v] = parents_[parents_[v]];
        return v;
    }
    [[nodiscard]] std::size_t count() const {
        std::size_t roots = 0;
        for (std::uint32_t v = 0; v < parents_.size(); ++v)
            roots += parents_[v] == v ? 1U : 0U;
        return roots;
    }

private:
    void join(std::uint32_t a, std::uint32_t b) { parents_[root(a)] = root(b); }

    std::vector<std::uint32_t> parents_;
};

void count_edges(const TriangleMesh& mesh, MeshFacts& facts) {
    PairIndex edges(mesh.vertices.size());
    std::vector<std::uint32_t> uses;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
            const std::uint32_t edge = edges.add(a, b);
            if (edge == uses.size()) uses.push_back(0);
            ++uses[edge];
        }
    }
    facts.edges = uses.size();
    facts.open_edges = static_cast<std::size_t>(std::ranges::count(uses, 1U));
}

void measure(const TriangleMesh& mesh, MeshFacts& facts) {
    if (mesh.vertices.empty()) return;
    facts.bounds = {.lo = mesh.vertices[0].point, .hi = mesh.vertices[0].point};
    for (const MeshVertex& vertex : mesh.vertices) {
        facts.bounds.lo = glm::min(facts.bounds.lo, vertex.point);
        facts.bounds.hi = glm::max(facts.bounds.hi, vertex.point);
    }
    const glm::dvec3 centre = facts.bounds.centre();
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[t[0]].point - centre;
        const glm::dvec3 b = mesh.vertices[t[1]].point - centre;
        const glm::dvec3 c = mesh.vertices[t[2]].point - centre;
        const glm::dvec3 across = glm::cross(b - a, c - a);
        facts.area += 0.5 * glm::length(across);
        facts.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
}

}  // namespace

MeshFacts counts_of(const TriangleMesh& mesh) {
    MeshFacts facts{.vertices = mesh.vertices.size(), .triangles = mesh.triangles.size()};
    count_edges(mesh, facts);
    facts.components = Groups(mesh).count();
    return facts;
}

MeshFacts facts_of(const TriangleMesh& mesh) {
    MeshFacts facts = counts_of(mesh);
    measure(mesh, facts);
    return facts;
}

std::vector<std::uint32_t> components_of(const TriangleMesh& mesh) {
    Groups groups(mesh);
    std::vector<std::uint32_t> components(mesh.vertices.size());
    for (std::uint32_t v = 0; v < components.size(); ++v)
        components[v] = groups.root(v);
    return components;
}

}  // namespace zeroset
