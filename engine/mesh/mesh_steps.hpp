#pragma once

#include "engine/mesh/cell_tree.hpp"
#include "engine/mesh/contour.hpp"
#include "engine/mesh/lattice.hpp"
#include "engine/mesh/make_mesh.hpp"
#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/solid.hpp"
#include "engine/mesh/triangle_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// The steps of make_mesh beside those that have classes of their own; make_mesh.cpp has their
// order. Each has a source of its own.

namespace zeroset {

/// A place near where parts of the solid meet: two at an edge, three or more at a corner.
struct PartsMeeting {
    std::vector<std::uint32_t> parts;
    glm::dvec3 point;
};
/// Brings places where the parts meet, by Newton's method for all of them. In upward rounding.
void approach_meetings(const MeshSolid& solid, std::vector<PartsMeeting>& places);

/// Moves the contour's vertices near edges of the solid onto them, by Newton's method for the two
/// parts that meet there; those that would go farther than a step of the lattice or so stay. In
/// upward rounding.
void sharpen_creases(const MeshSolid& solid, double step, Contour& contour, const MeshWork& work);

/// About how far each triangle lies from the surface: the most that is measured, by value over
/// slope, in its middle and in the middles of its sides. +inf where the function is not defined.
std::vector<float> deviations(const MeshSolid& solid, const TriangleMesh& mesh,
                              const MeshWork& work);

/// Gives the contour the edges and corners of the solid [Kobbelt01]: a tetrahedron in whose cells
/// the function may have a kink, and whose vertices' normals are of several kinds, gets a vertex
/// where the planes of each kind meet; and the side that two such tetrahedra share is turned to
/// join their new vertices, where that lies closer to the surface.
///   Differs from the paper: the grid is of tetrahedra, the planes are taken anew closer and closer
///   to the vertex, so that curved edges are met, too, and sides turn by measure.
/// In upward rounding.
void add_features(const CellTree& tree, const Lattice& lattice, const MeshSolid& solid,
                  Contour& contour, const MeshWork& work);

/// Puts vertices where sides of the contour's triangles cross an edge of the solid, between two
/// parts, that add_features did not find: so no such edge is cut off. In upward rounding.
void split_creased_sides(const MeshSolid& solid, double step, Contour& contour,
                         const MeshWork& work);

/// Divides tetrahedra at these vertices, and at those up to `rings` edges away, along which part of
/// the solid its function is: an edge whose ends are of two parts gets a vertex where they change,
/// a tetrahedron with such edges becomes a fan about the middle of these vertices. Then the levels
/// are as straight between vertices as the parts themselves, and sharp edges of the solid are edges
/// of the lattice's surface. For edges that are too sharp for the lattice as it is. Along an edge
/// some stars are proved by chance: what is divided beside what is not may fit neither, unless
/// there are rings. Returns whether any was divided. In upward rounding.
bool split_at_kinks(const MeshSolid& solid, std::span<const std::uint32_t> vertices, int rings,
                    Lattice& lattice, const MeshWork& work);

struct ThinOptions {
    double tolerance = 0.0;  ///< new triangles are measured to be no farther from the surface
    std::size_t most_triangles = 0;  ///< ends the work where so many are left; 0: as few as can be
    MeshWork work = {};
};

/// Collapses edges of a closed mesh while the tolerance holds, those that change it least first
/// [GarlandHeckbert97]. Vertices stay where they are, on the surface; those of creases go along
/// them only, corners stay. Topology does not change. In upward rounding.
void thin(TriangleMesh& mesh, const MeshSolid& solid, const ThinOptions& options);

/// Where the proof fails, values of the function near 0 tell little of its topology: turns `failed`
/// vertices of the lattice in one group of these cells after the other all outside or all inside,
/// but where a cell tells their side or is large, and keeps what leaves fewer handles and no fewer
/// components. Returns whether there was such; proofs of stars about there have to be made anew. In
/// upward rounding.
bool simplify_unproved(const CellTree& tree, std::span<const std::uint32_t> cells,
                       std::span<const std::uint32_t> failed, Lattice& lattice,
                       const MeshWork& work);

/// Groups of these leaves that touch one another, the largest first.
std::vector<UnprovedPlace> unproved_places(const CellTree& tree,
                                           std::span<const std::uint32_t> cells);
/// The leaves of each group.
std::vector<std::vector<std::uint32_t>> groups_of(const CellTree& tree,
                                                  std::span<const std::uint32_t> cells);

}  // namespace zeroset
