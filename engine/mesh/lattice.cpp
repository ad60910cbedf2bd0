#include "engine/mesh/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

std::uint64_t key_of(const Place& place) {
    constexpr unsigned bits = 21;
    return static_cast<std::uint64_t>(place.x) | static_cast<std::uint64_t>(place.y) << bits |
           static_cast<std::uint64_t>(place.z) << 2 * bits;
}

/// Walks over the faces between leaves and their edges.
class LatticeMaker {
public:
    LatticeMaker(const CellTree& tree, std::span<const std::uint32_t> leaves)
        : tree_(tree),
          leaves_(leaves),
          wanted_(tree.size()),
          corners_(2 * leaves.size()),
          vertices_(leaves.size()) {
        for (const std::uint32_t leaf : leaves)
            wanted_[leaf] = true;
    }
    Lattice make(const MeshWork& work);

private:
    void index_corners();
    void add_faces(std::uint32_t cell);
    void add_face(std::uint32_t cell, std::uint32_t other, int axis, int direction);
    void add_edge(std::uint32_t cell, std::uint32_t other, const Place& a, const Place& b);
    std::uint32_t vertex(const Place& place);

    const CellTree& tree_;
    std::span<const std::uint32_t> leaves_;
    std::vector<bool> wanted_;
    KeyIndex corners_, vertices_;
    Lattice lattice_;
};

void LatticeMaker::index_corners() {
    for (const std::uint32_t leaf : leaves_) {
        const MeshCell& cell = tree_[leaf];
        for (int corner = 0; corner < 8; ++corner) {
            const Place side(corner & 1, corner >> 1 & 1, corner >> 2);
            corners_.add(key_of(cell.corner + tree_.width(cell) * side));
        }
    }
}

std::uint32_t LatticeMaker::vertex(const Place& place) {
    const std::uint32_t id = vertices_.add(key_of(place));
    if (id == lattice_.vertices.size()) lattice_.vertices.push_back({.point = tree_.point(place)});
    return id;
}

void LatticeMaker::add_edge(std::uint32_t cell, std::uint32_t other, const Place& a,
                            const Place& b) {
    const Place half = (a + b) / 2;
    // A smaller leaf at this edge has a corner in its middle.
    const Place length = glm::abs(b - a);
    const bool shortest = length.x + length.y + length.z < 4;
    if (!shortest && corners_.find(key_of(half)) != KeyIndex::none) {
        add_edge(cell, other, a, half);
        add_edge(cell, other, half, b);
        return;
    }
    const std::uint32_t m = vertex(tree_.middle(tree_[cell]));
    const std::uint32_t n = vertex(tree_.middle(tree_[other]));
    lattice_.tetrahedra.push_back(
        {.vertices = {m, n, vertex(a), vertex(b)}, .cells = {cell, other}});
}

void LatticeMaker::add_face(std::uint32_t cell, std::uint32_t other, int axis, int direction) {
    const MeshCell& own = tree_[cell];
    const int width = tree_.width(own);
    Place corner = own.corner;
    if (direction > 0) corner[axis] += width;
    Place u(0);
    Place v(0);
    u[(axis + 1) % 3] = width;
    v[(axis + 2) % 3] = width;
    // Counter-clockwise as seen from where the axis points to.
    std::array<Place, 4> ring{corner, corner + u, corner + u + v, corner + v};
    if (direction < 0) std::ranges::reverse(ring);
    for (std::size_t i = 0; i < 4; ++i)
        add_edge(cell, other, ring[i], ring[(i + 1) % 4]);
}

void LatticeMaker::add_faces(std::uint32_t cell) {
    const MeshCell& own = tree_[cell];
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const int direction = face % 2 == 0 ? -1 : 1;
        const std::uint32_t other = tree_.neighbour(own, axis, direction);
        if (other >= tree_.size()) continue;
        const MeshCell& beyond = tree_[other];
        if (!beyond.is_leaf()) continue;  // the smaller cells there have the faces
        if (beyond.level == own.level && direction < 0) continue;  // that one has it
        if (!wanted_[other]) continue;
        if (own.is_active() || beyond.is_active()) add_face(cell, other, axis, direction);
    }
}

Lattice LatticeMaker::make(const MeshWork& work) {
    index_corners();
    for (const std::uint32_t leaf : leaves_) {
        if (work.limit.cancelled()) break;
        add_faces(leaf);
    }
    return std::move(lattice_);
}

/// Where a cell's side is proved, rounding must not say otherwise.
void trust_cells(const CellTree& tree, Lattice& lattice) {
    for (const Tetrahedron& tetrahedron : lattice.tetrahedra) {
        for (std::size_t k = 0; k < 2; ++k) {
            const BoxSide side = tree[tetrahedron.cells[k]].facts.side;
            if (side == BoxSide::Unknown) continue;
            for (const std::size_t vertex : {k, std::size_t{2}, std::size_t{3}}) {
                double& level = lattice.vertices[tetrahedron.vertices[vertex]].level;
                level = side == BoxSide::Inside ? -std::abs(level) : std::abs(level);
            }
        }
    }
}

}  // namespace

int Lattice::count_inside(const Tetrahedron& tetrahedron) const {
    return static_cast<int>(std::ranges::count_if(
        tetrahedron.vertices, [&](std::uint32_t vertex) { return inside(vertex); }));
}

double lattice_level(const SolidValue& value, double step) {
    const double level = std::clamp(value.distance(), 1e-9 * step, 1e6 * step);
    return value.inside() ? -level : level;
}

Lattice make_lattice(const CellTree& tree, const MeshSolid& solid, const MeshWork& work) {
    std::vector<std::uint32_t> leaves;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        if (tree[i].is_leaf()) leaves.push_back(i);
    }
    return make_lattice(tree, leaves, solid, work);
}

Lattice make_lattice(const CellTree& tree, std::span<const std::uint32_t> leaves,
                     const MeshSolid& solid, const MeshWork& work) {
    Lattice lattice = LatticeMaker(tree, leaves).make(work);
    std::vector<glm::dvec3> points;
    points.reserve(lattice.vertices.size());
    for (const LatticeVertex& vertex : lattice.vertices)
        points.push_back(vertex.point);
    const std::vector<SolidValue> values = field_at(solid, points, work);
    lattice.step = tree.step();
    for (std::size_t i = 0; i < values.size(); ++i) {
        lattice.vertices[i].level = lattice_level(values[i], lattice.step);
        lattice.vertices[i].part = values[i].part;
    }
    trust_cells(tree, lattice);
    return lattice;
}

}  // namespace zeroset
