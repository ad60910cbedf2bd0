#pragma once

#include "engine/mesh/cell_tree.hpp"
#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/place_index.hpp"

#include <array>
#include <cstdint>
#include <vector>

// The tetrahedra between the cells of an octree [JuUdeshi06, sec. 3]: for each face that two leaves
// share, and each edge of it that no smaller leaf divides, the tetrahedron of the two middles and
// the edge's ends. They fill the root without gaps and meet face to face, however the sizes of
// neighbours differ: the segment between the middles always crosses the face.

namespace zeroset {

/// A tetrahedron; of positive volume.
struct Tetrahedron {
    std::array<std::uint32_t, 4> vertices;  ///< the middles of `cells`, then the edge's ends
    std::array<std::uint32_t, 2> cells;
};

struct LatticeVertex {
    Place place;
    double level;  ///< about the distance from the surface, below 0 inside; never 0
    std::uint32_t part = 0;  ///< FieldValue::part
};

/// The tetrahedra at the surface and at all cells that it may go through.
struct Lattice {
    std::vector<LatticeVertex> vertices;
    std::vector<Tetrahedron> tetrahedra;

    [[nodiscard]] bool inside(std::uint32_t vertex) const { return vertices[vertex].level < 0; }
    /// The number of its vertices inside, 0 to 4.
    [[nodiscard]] int count_inside(const Tetrahedron& tetrahedron) const;
};

/// In upward rounding.
Lattice make_lattice(const CellTree& tree, const MeshSolid& solid, int threads);

}  // namespace zeroset
