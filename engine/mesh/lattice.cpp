#include "engine/mesh/lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace zeroset {
namespace {

std::uint64_t key_of(const Place& place) {
    constexpr unsigned bits = 21;
    return static_cast<std::uint64_t>(place.x) | static_cast<std::uint64_t>(place.y) << bits |
           static_cast<std::uint64_t>(place.z) << 2 * bits;
}

using Four = std::array<std::uint32_t, 4>;

/// Walks over the edges of leaves that no smaller leaf divides, each with the leaves about it, from
/// the root down through faces and edges between cells [JuEtAl02].
///   Four cells about an edge stand counter-clockwise as seen from where its axis points to, the
///   first on the lower side along both other axes.
class LatticeMaker {
public:
    LatticeMaker(const CellTree& tree, std::span<const std::uint32_t> leaves, const MeshWork& work)
        : tree_(tree),
          work_(work),
          holds_(tree.size()),
          middles_(tree.size(), KeyIndex::none),
          corners_(leaves.size()) {
        for (const std::uint32_t leaf : leaves)
            holds_[leaf] = wanted;
    }
    Lattice make();

private:
    static constexpr std::uint8_t wanted = 1, active = 2;

    void find_leaves();
    /// Whether there may be a wanted and an active leaf among those in cells.
    [[nodiscard]] bool may_add(std::span<const std::uint32_t> cells) const {
        unsigned all = 0;
        for (const std::uint32_t cell : cells)
            all |= holds_[cell];
        return all == (wanted | active);
    }
    [[nodiscard]] std::uint32_t child(std::uint32_t cell, int number) const {
        const MeshCell& own = tree_[cell];
        return own.is_leaf() ? cell : own.first_child + static_cast<std::uint32_t>(number);
    }
    void walk_cell(std::uint32_t cell);
    void walk_face(int axis, std::uint32_t below, std::uint32_t above);
    void walk_edge(int axis, const Four& cells);
    void add_edge(int axis, const Four& cells);
    std::uint32_t middle(std::uint32_t cell);
    std::uint32_t corner(const Place& place);
    std::uint32_t add_vertex(const Place& place) {
        lattice_.vertices.push_back({.point = tree_.point(place)});
        return static_cast<std::uint32_t>(lattice_.vertices.size() - 1);
    }

    const CellTree& tree_;
    const MeshWork& work_;
    /// Bits of cells: whether a wanted leaf is in it, an active one.
    std::vector<std::uint8_t> holds_;
    std::vector<std::uint32_t> middles_;
    KeyIndex corners_;
    std::vector<std::uint32_t> corner_vertices_;
    Lattice lattice_;
};

/// The bit of a child's number for its side along an axis.
constexpr int side_bit(int axis) { return 1 << axis; }

void LatticeMaker::find_leaves() {
    // Children stand behind their parents.
    for (std::size_t i = tree_.size(); i-- > 0;) {
        const MeshCell& cell = tree_[i];
        if (cell.is_leaf() && cell.is_active()) holds_[i] |= active;
        for (std::uint32_t k = 0; k < 8 && !cell.is_leaf(); ++k)
            holds_[i] |= holds_[cell.first_child + k];
    }
}

void LatticeMaker::walk_cell(std::uint32_t cell) {
    if (tree_[cell].is_leaf() || !may_add(std::array{cell}) || work_.limit.cancelled()) return;
    for (int k = 0; k < 8; ++k)
        walk_cell(child(cell, k));
    for (int axis = 0; axis < 3; ++axis) {
        const int along = side_bit(axis);
        const int u = side_bit((axis + 1) % 3);
        const int v = side_bit((axis + 2) % 3);
        for (const int k : {0, u, u | v, v})
            walk_face(axis, child(cell, k), child(cell, k | along));
        for (const int k : {0, along})
            walk_edge(axis, {child(cell, k), child(cell, k | u), child(cell, k | u | v),
                             child(cell, k | v)});
    }
}

void LatticeMaker::walk_face(int axis, std::uint32_t below, std::uint32_t above) {
    if (tree_[below].is_leaf() && tree_[above].is_leaf()) return;
    if (!may_add(std::array{below, above})) return;
    const int along = side_bit(axis);
    const std::array<int, 2> across{(axis + 1) % 3, (axis + 2) % 3};
    const int u = side_bit(across[0]);
    const int v = side_bit(across[1]);
    for (const int k : {0, u, u | v, v})
        walk_face(axis, child(below, k | along), child(above, k));
    // The edges in the face's middle: along u the cells go round from below to above to v.
    for (const int k : {0, u})
        walk_edge(across[0], {child(below, k | along), child(below, k | along | v),
                              child(above, k | v), child(above, k)});
    for (const int k : {0, v})
        walk_edge(across[1], {child(below, k | along), child(above, k), child(above, k | u),
                              child(below, k | along | u)});
}

void LatticeMaker::walk_edge(int axis, const Four& cells) {
    if (!may_add(cells)) return;
    if (std::ranges::all_of(cells, [&](std::uint32_t cell) { return tree_[cell].is_leaf(); }))
        return add_edge(axis, cells);
    const int along = side_bit(axis);
    const int u = side_bit((axis + 1) % 3);
    const int v = side_bit((axis + 2) % 3);
    for (const int k : {0, along})
        walk_edge(axis, {child(cells[0], k | u | v), child(cells[1], k | v), child(cells[2], k),
                         child(cells[3], k | u)});
}

std::uint32_t LatticeMaker::middle(std::uint32_t cell) {
    if (middles_[cell] == KeyIndex::none) middles_[cell] = add_vertex(tree_.middle(tree_[cell]));
    return middles_[cell];
}

std::uint32_t LatticeMaker::corner(const Place& place) {
    const std::uint32_t id = corners_.add(key_of(place));
    if (id == corner_vertices_.size()) corner_vertices_.push_back(add_vertex(place));
    return corner_vertices_[id];
}

void LatticeMaker::add_edge(int axis, const Four& cells) {
    std::array<bool, 4> shares{};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t a = cells[i];
        const std::uint32_t b = cells[(i + 1) % 4];
        shares[i] = a != b && may_add(std::array{a, b});
    }
    if (!std::ranges::any_of(shares, [](bool own) { return own; })) return;
    std::size_t smallest = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        if (tree_[cells[i]].level > tree_[cells[smallest]].level) smallest = i;
    }
    const MeshCell& cell = tree_[cells[smallest]];
    const int width = tree_.width(cell);
    Place start = cell.corner;
    if (smallest == 0 || smallest == 3) start[(axis + 1) % 3] += width;
    if (smallest < 2) start[(axis + 2) % 3] += width;
    Place end = start;
    end[axis] += width;
    const std::uint32_t from = corner(start);
    const std::uint32_t to = corner(end);
    for (std::size_t i = 0; i < 4; ++i) {
        if (!shares[i]) continue;
        const std::uint32_t a = cells[i];
        const std::uint32_t b = cells[(i + 1) % 4];
        lattice_.tetrahedra.push_back({.vertices = {middle(a), middle(b), from, to},
                                       .cells = {a, b},
                                       .newest = std::ranges::max(cells)});
    }
}

Lattice LatticeMaker::make() {
    find_leaves();
    walk_cell(0);
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
    Lattice lattice = LatticeMaker(tree, leaves, work).make();
    std::vector<glm::dvec3> points;
    points.reserve(lattice.vertices.size());
    for (const LatticeVertex& vertex : lattice.vertices)
        points.push_back(vertex.point);
    const std::vector<SolidValue> values = field_at(solid, points, work, Normals::Without);
    lattice.step = tree.step();
    for (std::size_t i = 0; i < values.size(); ++i) {
        lattice.vertices[i].level = lattice_level(values[i], lattice.step);
        lattice.vertices[i].part = values[i].part;
    }
    trust_cells(tree, lattice);
    return lattice;
}

}  // namespace zeroset
