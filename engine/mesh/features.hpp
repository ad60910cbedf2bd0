#pragma once

#include "engine/mesh/contour.hpp"
#include "engine/mesh/mesh_work.hpp"

namespace zeroset {

/// Gives the contour the edges and corners of the solid [Kobbelt01]: a tetrahedron in whose cells
/// the function may have a kink, and whose vertices' normals are of several kinds, gets a vertex
/// where the planes of each kind meet; and the side that two such tetrahedra share is turned to
/// join their new vertices, where that lies closer to the surface.
///   Differs from the paper: the grid is of tetrahedra, the planes are taken anew closer and closer
///   to the vertex, so that curved edges are met, too, and sides turn by measure.
/// In upward rounding.
void add_features(const CellTree& tree, const Lattice& lattice, const MeshSolid& solid,
                  Contour& contour, const MeshWork& work);

}  // namespace zeroset
