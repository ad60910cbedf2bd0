#include "engine/mesh/collapsible_mesh.hpp"
#include "engine/mesh/finished_mesh.hpp"
#include "engine/mesh/mesh_facts.hpp"
#include "engine/mesh/place_index.hpp"

#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

// Readers of files take vertices at the same numbers for one. Such vertices are made one where the
// mesh stays as it is, and moved apart by the least that numbers tell elsewhere.

namespace zeroset {
namespace {

/// A point's numbers in a file, as one; of different points the same by an unlikely chance only.
std::uint64_t key_of(const glm::dvec3& point, double scale) {
    constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ULL;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
        // + 0 makes -0 the 0 that it equals.
        const auto number = static_cast<float>(scale * point[axis]) + 0.0F;
        key = (std::rotl(key, 29) ^ std::bit_cast<std::uint32_t>(number)) * golden;
    }
    return key;
}

/// The number of each vertex among the different points.
std::vector<std::uint32_t> places_of(const TriangleMesh& mesh, double scale) {
    KeyIndex index(mesh.vertices.size());
    std::vector<std::uint32_t> places;
    places.reserve(mesh.vertices.size());
    for (const MeshVertex& vertex : mesh.vertices)
        places.push_back(index.add(key_of(vertex.point, scale)));
    return places;
}

/// Vertices at whose point an earlier one is.
std::vector<std::uint32_t> repeated(const std::vector<std::uint32_t>& places) {
    std::vector<std::uint32_t> found;
    std::uint32_t different = 0;
    for (std::uint32_t v = 0; v < places.size(); ++v) {
        if (places[v] == different) {
            ++different;
        } else {
            found.push_back(v);
        }
    }
    return found;
}

/// Makes vertices at one point one, where there is an edge between them that may be collapsed;
/// `sources` gets which vertices are left.
void join_repeated(TriangleMesh& mesh, double scale, std::vector<std::uint32_t>& sources) {
    const std::vector<std::uint32_t> places = places_of(mesh, scale);
    const std::vector<std::uint32_t> found = repeated(places);
    if (found.empty() || facts_of(mesh).open_edges > 0) return;
    CollapsibleMesh collapsible(std::move(mesh));
    std::vector<std::uint32_t> ring;
    const auto join = [&](std::uint32_t v) {
        collapsible.ring(v, ring);
        for (const std::uint32_t other : ring) {
            if (places[other] != places[v] || !collapsible.may_collapse(v, other, ring)) continue;
            collapsible.raise_kind(other, collapsible.vertex(v).kind);
            collapsible.collapse(v, other);
            return true;
        }
        return false;
    };
    for (bool any = true; any;) {
        any = false;
        for (const std::uint32_t v : found)
            any = join(v) || any;
    }
    std::vector<std::uint32_t> left;
    for (std::uint32_t v = 0; v < collapsible.size(); ++v) {
        if (!collapsible.star(v).empty()) left.push_back(sources[v]);
    }
    sources = std::move(left);
    mesh = collapsible.finish();
}

/// Moves vertices at the point of another one towards what is beside them.
void move_apart(TriangleMesh& mesh, double scale) {
    KeyIndex index(mesh.vertices.size());
    std::vector<glm::dvec3> beside(mesh.vertices.size(), glm::dvec3(0.0));
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3& point = mesh.vertices[t.at(k)].point;
            for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3})
                beside[t.at(k)] += mesh.vertices[t.at(other)].point - point;
        }
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        glm::dvec3& point = mesh.vertices[v].point;
        const glm::dvec3 start = point;
        const glm::dvec3 size = glm::abs(start);
        double step = 0x1p-23 * (size.x + size.y + size.z);
        const double length = glm::length(beside[v]);
        const glm::dvec3 way = length > 0 ? beside[v] / length : glm::dvec3(0.0, 0.0, 1.0);
        const std::size_t before = index.keys().size();
        for (; std::isfinite(step); step *= 2.0) {
            index.add(key_of(point, scale));
            if (index.keys().size() > before) break;
            point = start + step * way;
        }
    }
}

}  // namespace

std::vector<std::uint32_t> make_numbers_different(TriangleMesh& mesh,
                                                  std::span<const double> scales) {
    std::vector<std::uint32_t> sources(mesh.vertices.size());
    std::iota(sources.begin(), sources.end(), 0U);
    for (const double scale : scales)
        join_repeated(mesh, scale, sources);
    // Points moved apart for one scale may meet in another.
    constexpr int most_rounds = 3;
    bool moved = true;
    for (int round = 0; moved && round < most_rounds; ++round) {
        moved = false;
        for (const double scale : scales) {
            if (repeated(places_of(mesh, scale)).empty()) continue;
            move_apart(mesh, scale);
            moved = true;
        }
    }
    return sources;
}

}  // namespace zeroset
