#pragma once

#include "engine/mesh/lattice.hpp"
#include "engine/mesh/mesh_work.hpp"

#include <cstdint>
#include <span>
#include <vector>

// The proof that a mesh has the surface's topology.
//
//   F    the solid's function, cut off at -e and e, where e > 0 is smaller than all values that it
//        is proved not to go below anywhere: of its zeros it has all, of its slopes only those near
//   L    levels at the lattice's vertices, linear in each tetrahedron
//   F_t  (1 - t) F + t L, 0 <= t <= 1
//   star the tetrahedra about a vertex         d    a direction, one for each vertex
//
// If along its vertex's d both F near its zeros, in all cells that a star meets, and L, in all its
// tetrahedra, surely rise, then so does every F_t where it is 0, whatever kinks F has: all
// generalized gradients [Clarke90] at a point are mixtures of those nearby, and beside its zeros
// those of F are 0. The directions, mixed by the vertices' barycentric weights, are a field D
// across which all F_t = 0 lie; sliding along D carries F = 0 to L = 0 without ever letting two
// places meet: the two are isotopic. Between two cells that are proved to be empty no F_t is 0.
// L = 0 crosses an edge where it is not 0 at the ends; moving that point along the edge, to F's
// root, is an isotopy, too.
//
// The condition is that of [PlantingaVegter04] (gradients in a cell have positive products), but
// held against what was built instead of what is built from it: so kinks may pass, cells need not
// be of like sizes, and the levels may be rounded as they are.

namespace zeroset {

/// The stars that the proof fails for.
struct StarProof {
    std::size_t stars = 0;              ///< all that there are
    std::vector<std::uint32_t> failed;  ///< vertices
    /// Active leaves in their tetrahedra, each once; `rough`: those only of stars in which F has a
    /// kink and is proved to rise, but L is not.
    std::vector<std::uint32_t> unknown, rough;
};

/// In upward rounding. Stars that are left when the time is over count as not proved.
StarProof prove_stars(const CellTree& tree, const Lattice& lattice, const MeshWork& work);
/// Only of stars with a tetrahedron at one of these leaves or at a cell from `first_new` on; the
/// lattice has all leaves that touch those beside them.
StarProof prove_stars(const CellTree& tree, const Lattice& lattice,
                      std::span<const std::uint32_t> leaves, std::uint32_t first_new,
                      const MeshWork& work);

}  // namespace zeroset
