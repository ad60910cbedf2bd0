#include "tests/support/mesh_checks.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace zeroset::test {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::string text_of(const Edge& edge) {
    return std::to_string(edge.first) + "-" + std::to_string(edge.second);
}

std::string wrong_triangle(const TriangleMesh& mesh) {
    std::set<Triangle> seen;
    for (Triangle triangle : mesh.triangles) {
        std::ranges::sort(triangle);
        if (triangle[2] >= mesh.vertices.size()) return "a vertex does not exist";
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2])
            return "a triangle has a vertex twice";
        if (!seen.insert(triangle).second) return "a triangle is there twice";
    }
    return "";
}

std::string wrong_edge(const TriangleMesh& mesh) {
    std::map<Edge, int> uses;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            ++uses[{t[k], t[(k + 1) % 3]}];
    }
    for (const auto& [edge, count] : uses) {
        if (count != 1) return "edge " + text_of(edge) + " runs twice in one direction";
        if (!uses.contains({edge.second, edge.first})) return "edge " + text_of(edge) + " is open";
    }
    return "";
}

/// Whether the triangles about each vertex follow one another in a single ring.
std::string wrong_ring(const TriangleMesh& mesh) {
    std::vector<std::map<std::uint32_t, std::uint32_t>> next(mesh.vertices.size());
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            next[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
    }
    for (std::size_t v = 0; v < next.size(); ++v) {
        if (next[v].empty()) return "vertex " + std::to_string(v) + " has no triangle";
        const std::uint32_t first = next[v].begin()->first;
        std::size_t length = 0;
        std::uint32_t at = first;
        do {
            at = next[v].at(at);
            ++length;
        } while (at != first && length <= next[v].size());
        if (length != next[v].size()) return "vertex " + std::to_string(v) + " has several rings";
    }
    return "";
}

}  // namespace

std::string defect_of(const TriangleMesh& mesh) {
    for (const auto check : {wrong_triangle, wrong_edge, wrong_ring}) {
        std::string wrong = check(mesh);
        if (!wrong.empty()) return wrong;
    }
    return "";
}

long long euler_characteristic(const TriangleMesh& mesh) {
    std::set<Edge> edges;
    std::set<std::uint32_t> vertices;
    for (const Triangle& t : mesh.triangles) {
        vertices.insert(t.begin(), t.end());
        for (std::size_t k = 0; k < 3; ++k)
            edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
    return static_cast<long long>(vertices.size()) - static_cast<long long>(edges.size()) +
           static_cast<long long>(mesh.triangles.size());
}

double enclosed_volume(const TriangleMesh& mesh) {
    double volume = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3& a = mesh.vertices[t[0]].point;
        volume += glm::dot(a, glm::cross(mesh.vertices[t[1]].point, mesh.vertices[t[2]].point));
    }
    return volume / 6.0;
}

}  // namespace zeroset::test
