#pragma once

#include "engine/mesh/lattice.hpp"
#include "engine/mesh/mesh_work.hpp"

#include <cstdint>
#include <span>

namespace zeroset {

/// Divides tetrahedra at these vertices, and at those up to `rings` edges away, along which part of
/// the solid its function is: an edge whose ends are of two parts gets a vertex where they change,
/// a tetrahedron with such edges becomes a fan about the middle of these vertices. Then the levels
/// are as straight between vertices as the parts themselves, and sharp edges of the solid are edges
/// of the lattice's surface. For edges that are too sharp for the lattice as it is. Along an edge
/// some stars are proved by chance: what is divided beside what is not may fit neither, unless
/// there are rings. In upward rounding.
void split_at_kinks(const MeshSolid& solid, std::span<const std::uint32_t> vertices, int rings,
                    Lattice& lattice, const MeshWork& work);

}  // namespace zeroset
