#pragma once

#include "engine/mesh/cell_tree.hpp"
#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/place_index.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

// The tetrahedra between the cells of an octree [JuUdeshi06, sec. 3]: for each face that two leaves
// share, and each edge of it that no smaller leaf divides, the tetrahedron of the two middles and
// the edge's ends. They fill the root without gaps and meet face to face, however the sizes of
// neighbours differ: the segment between the middles always crosses the face.

namespace zeroset {

/// A tetrahedron; of positive volume.
struct Tetrahedron {
    std::array<std::uint32_t, 4> vertices;  ///< the middles of `cells`, then the edge's ends; or a
                                            ///< piece of such a one
    std::array<std::uint32_t, 2> cells;
    std::uint32_t newest = 0;  ///< of all cells at its edge, by their numbers
};

struct LatticeVertex {
    static constexpr std::uint32_t no_part = ~std::uint32_t{0};

    glm::dvec3 point{0.0};
    double level = 0.0;      ///< about the distance from the surface, below 0 inside; never 0
    std::uint32_t part = 0;  ///< SolidValue::part
    /// The parts that change there, of a vertex that split_at_kinks made.
    std::array<std::uint32_t, 2> kink{no_part, no_part};

    [[nodiscard]] bool is_kink() const { return kink[0] != no_part; }
};

/// The tetrahedra at the surface and at all cells that it may go through.
struct Lattice {
    std::vector<LatticeVertex> vertices;
    std::vector<Tetrahedron> tetrahedra;
    double step = 0.0;  ///< between places

    [[nodiscard]] bool inside(std::uint32_t vertex) const { return vertices[vertex].level < 0; }
    /// The number of its vertices inside, 0 to 4.
    [[nodiscard]] int count_inside(const Tetrahedron& tetrahedron) const;
};

/// The value's level, neither 0 nor so large that differences lose the small ones.
double lattice_level(const SolidValue& value, double step);

/// In upward rounding.
Lattice make_lattice(const CellTree& tree, const MeshSolid& solid, const MeshWork& work);
/// Only tetrahedra at these leaves.
Lattice make_lattice(const CellTree& tree, std::span<const std::uint32_t> leaves,
                     const MeshSolid& solid, const MeshWork& work);

}  // namespace zeroset
