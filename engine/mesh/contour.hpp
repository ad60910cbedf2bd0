#pragma once

#include "engine/mesh/cell_tree.hpp"
#include "engine/mesh/lattice.hpp"
#include "engine/mesh/mesh_facts.hpp"
#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/triangle_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// The surface as triangles in the lattice's tetrahedra (marching tetrahedra [Doi91]): a vertex for
/// each edge with one end inside, at the function's root there, and one or two triangles for each
/// tetrahedron, so that every edge has two triangles and every vertex one ring of them.
struct Contour {
    /// A vertex near an edge of the solid, where two parts are 0.
    struct Crease {
        std::uint32_t vertex;
        std::array<std::uint32_t, 2> parts;
    };

    TriangleMesh mesh;
    std::vector<std::uint32_t> tetrahedra;  ///< of each triangle, the one that it lies in
    std::vector<Crease> creases;
};

/// The triangles before vertices have places: vertices have the numbers of the edges they lie on.
struct MarchedLattice {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> tetrahedra;  ///< of each triangle
    std::vector<std::uint64_t> edges;       ///< pair_key of the ends inside and outside
};
MarchedLattice march(const Lattice& lattice);

/// In upward rounding.
Contour make_contour(const Lattice& lattice, const MeshSolid& solid, const MeshWork& work);
/// The contour with vertices joined where it is smooth and that takes it no farther than the
/// tolerance from the surface, as far as is measured. `cells`, and those with kinks, keep all their
/// triangles. In upward rounding.
Contour make_coarse_contour(const CellTree& tree, const Lattice& lattice,
                            std::span<const std::uint32_t> cells, const MeshSolid& solid,
                            double tolerance, const MeshWork& work);

/// How many components and handles the contour has, all together.
std::size_t contour_complexity(const Lattice& lattice);
/// The contour's counts.
MeshFacts contour_facts(const Lattice& lattice);

/// Roots of the solid's function between points inside and outside, by Newton's method within
/// brackets; where it jumps, the place of the jump. Those that are left when the time is over are
/// as close as they were.
struct CrossedEdge {
    glm::dvec3 inside, outside;
};
std::vector<MeshVertex> find_roots(const MeshSolid& solid, const std::vector<CrossedEdge>& brackets,
                                   const MeshWork& work);
/// The vertices on these edges of the lattice. One along which two parts change lies on an edge of
/// the solid.
std::vector<MeshVertex> vertices_on(const Lattice& lattice, std::span<const std::uint64_t> edges,
                                    const MeshSolid& solid, const MeshWork& work);
/// The creases among vertices that lie on these edges of the lattice.
std::vector<Contour::Crease> creases_on(const Lattice& lattice,
                                        std::span<const std::uint64_t> edges);

}  // namespace zeroset
