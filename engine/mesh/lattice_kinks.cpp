#include "engine/mesh/mesh_steps.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

using Side3 = std::array<std::uint32_t, 3>;

double volume(const std::array<glm::dvec3, 4>& v) {
    return glm::dot(v[1] - v[0], glm::cross(v[2] - v[0], v[3] - v[0]));
}

class KinkSplitter {
public:
    KinkSplitter(const MeshSolid& solid, std::span<const std::uint32_t> vertices, int rings,
                 Lattice& lattice, const MeshWork& work)
        : solid_(solid),
          lattice_(lattice),
          work_(work),
          wanted_(lattice.vertices.size()),
          edges_(1024) {
        for (const std::uint32_t vertex : vertices)
            wanted_[vertex] = true;
        for (int i = 0; i < rings; ++i)
            want_neighbours();
    }
    bool split();

private:
    void want_neighbours();
    void find_edges();
    void find_changes();
    void split_tetrahedron(const Tetrahedron& tetrahedron);
    [[nodiscard]] glm::dvec3 tip_of(const std::array<std::uint32_t, 4>& v,
                                    const glm::dvec3& middle) const;
    void split_face(const Side3& face, std::vector<Side3>& pieces) const;
    [[nodiscard]] bool changes(std::uint32_t a, std::uint32_t b) const;
    /// The new vertex on an edge; KeyIndex::none: there is none.
    [[nodiscard]] std::uint32_t on_edge(std::uint32_t a, std::uint32_t b) const {
        const auto [lo, hi] = std::minmax(a, b);
        const std::uint32_t edge = edges_.find(pair_key(lo, hi));
        return edge == KeyIndex::none ? edge : vertices_[edge];
    }
    std::uint32_t add_vertex(const glm::dvec3& point, const std::array<std::uint32_t, 2>& parts);
    void find_levels(std::size_t first);

    const MeshSolid& solid_;
    Lattice& lattice_;
    const MeshWork& work_;
    std::vector<bool> wanted_;             ///< vertices whose edges are divided
    KeyIndex edges_;                       ///< with a change of the part
    std::vector<std::uint32_t> vertices_;  ///< on them
    std::vector<Tetrahedron> result_;
};

void KinkSplitter::want_neighbours() {
    std::vector<bool> more = wanted_;
    for (const Tetrahedron& tetrahedron : lattice_.tetrahedra) {
        const auto& v = tetrahedron.vertices;
        if (!std::ranges::any_of(v, [&](std::uint32_t vertex) { return wanted_[vertex]; }))
            continue;
        for (const std::uint32_t vertex : v)
            more[vertex] = true;
    }
    wanted_ = std::move(more);
}

/// Whether the ends of an edge near the surface are of two parts.
bool KinkSplitter::changes(std::uint32_t a, std::uint32_t b) const {
    const LatticeVertex& first = lattice_.vertices[a];
    const LatticeVertex& second = lattice_.vertices[b];
    if (first.part == second.part || !(wanted_[a] || wanted_[b])) return false;
    const double near = 2.0 * glm::distance(first.point, second.point);
    return std::abs(first.level) < near && std::abs(second.level) < near;
}

void KinkSplitter::find_edges() {
    for (const Tetrahedron& tetrahedron : lattice_.tetrahedra) {
        const auto& v = tetrahedron.vertices;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t k = i + 1; k < 4; ++k) {
                const auto [lo, hi] = std::minmax(v[i], v[k]);
                if (changes(lo, hi)) edges_.add(pair_key(lo, hi));
            }
        }
    }
}

std::uint32_t KinkSplitter::add_vertex(const glm::dvec3& point,
                                       const std::array<std::uint32_t, 2>& parts) {
    lattice_.vertices.push_back({.point = point, .level = 0.0, .part = parts[0], .kink = parts});
    return static_cast<std::uint32_t>(lattice_.vertices.size() - 1);
}

/// Bisects the edges by the part.
void KinkSplitter::find_changes() {
    constexpr int steps = 30;
    // New vertices keep away from the old ones, or tetrahedra would get too flat.
    constexpr double apart = 1e-4;
    const std::size_t count = edges_.keys().size();
    std::vector<double> lo(count, 0.0);
    std::vector<double> hi(count, 1.0);
    std::vector<glm::dvec3> points(count);
    const auto ends = [&](std::size_t i) {
        const std::uint64_t key = edges_.keys()[i];
        return std::pair{static_cast<std::uint32_t>(key >> 32U), static_cast<std::uint32_t>(key)};
    };
    const auto point_at = [&](std::size_t i, double t) {
        const auto [a, b] = ends(i);
        const glm::dvec3& from = lattice_.vertices[a].point;
        return from + t * (lattice_.vertices[b].point - from);
    };
    for (int step = 0; step < steps; ++step) {
        for (std::size_t i = 0; i < count; ++i)
            points[i] = point_at(i, 0.5 * (lo[i] + hi[i]));
        const std::vector<SolidValue> values = field_at(solid_, points, work_);
        for (std::size_t i = 0; i < count; ++i) {
            const bool first = values[i].part == lattice_.vertices[ends(i).first].part;
            (first ? lo[i] : hi[i]) = 0.5 * (lo[i] + hi[i]);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto [a, b] = ends(i);
        const std::array parts{lattice_.vertices[a].part, lattice_.vertices[b].part};
        vertices_.push_back(add_vertex(point_at(i, std::clamp(hi[i], apart, 1.0 - apart)), parts));
    }
}

/// The triangles that a face becomes, turned as it is; as the tetrahedron across it does, too.
void KinkSplitter::split_face(const Side3& face, std::vector<Side3>& pieces) const {
    Side3 between{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        between[k] = on_edge(face[k], face[(k + 1) % 3]);
        count += between[k] != KeyIndex::none ? 1U : 0U;
    }
    if (count == 0) return pieces.push_back(face);
    if (count == 3) {
        pieces.push_back(between);
        for (std::size_t k = 0; k < 3; ++k)
            pieces.push_back({face[k], between[k], between[(k + 2) % 3]});
        return;
    }
    // Turned so that the first edge is whole of two, or divided if it is the only one.
    std::size_t k = 0;
    while ((between[k] != KeyIndex::none) != (count == 1))
        ++k;
    const Side3 v{face[k], face[(k + 1) % 3], face[(k + 2) % 3]};
    const Side3 m{between[k], between[(k + 1) % 3], between[(k + 2) % 3]};
    if (count == 1) {
        pieces.push_back({v[0], m[0], v[2]});
        pieces.push_back({m[0], v[1], v[2]});
        return;
    }
    pieces.push_back({m[1], v[2], m[2]});
    if (v[0] < v[1]) {  // the diagonal of the rest begins at its smaller old vertex
        pieces.push_back({v[0], v[1], m[1]});
        pieces.push_back({v[0], m[1], m[2]});
    } else {
        pieces.push_back({v[0], v[1], m[2]});
        pieces.push_back({v[1], m[1], m[2]});
    }
}

/// `middle`, if it is well inside the tetrahedron; else a point between it and the centre.
glm::dvec3 KinkSplitter::tip_of(const std::array<std::uint32_t, 4>& v,
                                const glm::dvec3& middle) const {
    constexpr double inside = 1e-9;
    std::array<glm::dvec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = lattice_.vertices[v[i]].point;
    const double whole = volume(corners);
    bool good = true;
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<glm::dvec3, 4> part = corners;
        part[i] = middle;
        good = good && volume(part) > inside * whole;
    }
    if (good) return middle;
    return 0.5 * middle + 0.125 * (corners[0] + corners[1] + corners[2] + corners[3]);
}

void KinkSplitter::split_tetrahedron(const Tetrahedron& tetrahedron) {
    const auto& v = tetrahedron.vertices;
    glm::dvec3 sum(0.0);
    double count = 0.0;
    std::array<std::uint32_t, 2> parts{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = i + 1; k < 4; ++k) {
            const std::uint32_t vertex = on_edge(v[i], v[k]);
            if (vertex == KeyIndex::none) continue;
            sum += lattice_.vertices[vertex].point;
            parts = lattice_.vertices[vertex].kink;
            count += 1.0;
        }
    }
    if (count == 0.0) {
        result_.push_back(tetrahedron);
        return;
    }
    const std::uint32_t apex = add_vertex(tip_of(v, sum / count), parts);
    std::vector<Side3> pieces;
    // The faces, each turned to be seen counter-clockwise from the vertex that it lacks.
    for (const Side3& face : {Side3{v[1], v[2], v[3]}, Side3{v[0], v[3], v[2]},
                              Side3{v[0], v[1], v[3]}, Side3{v[0], v[2], v[1]}})
        split_face(face, pieces);
    for (const Side3& piece : pieces)
        result_.push_back({.vertices = {apex, piece[0], piece[1], piece[2]},
                           .cells = tetrahedron.cells,
                           .newest = KeyIndex::none});
}

void KinkSplitter::find_levels(std::size_t first) {
    std::vector<glm::dvec3> points;
    for (std::size_t i = first; i < lattice_.vertices.size(); ++i)
        points.push_back(lattice_.vertices[i].point);
    const std::vector<SolidValue> values = field_at(solid_, points, work_);
    for (std::size_t i = 0; i < values.size(); ++i) {
        LatticeVertex& vertex = lattice_.vertices[first + i];
        vertex.level = lattice_level(values[i], lattice_.step);
        vertex.part = values[i].part;
    }
}

bool KinkSplitter::split() {
    find_edges();
    if (edges_.keys().empty()) return false;
    const std::size_t first = lattice_.vertices.size();
    find_changes();
    result_.reserve(lattice_.tetrahedra.size());
    for (const Tetrahedron& tetrahedron : lattice_.tetrahedra)
        split_tetrahedron(tetrahedron);
    lattice_.tetrahedra = std::move(result_);
    find_levels(first);
    return true;
}

}  // namespace

bool split_at_kinks(const MeshSolid& solid, std::span<const std::uint32_t> vertices, int rings,
                    Lattice& lattice, const MeshWork& work) {
    return KinkSplitter(solid, vertices, rings, lattice, work).split();
}

}  // namespace zeroset
