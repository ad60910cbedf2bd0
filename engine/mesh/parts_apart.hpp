#pragma once

#include "engine/mesh/make_mesh.hpp"
#include "engine/mesh/mesh_work.hpp"
#include "engine/mesh/solid.hpp"

#include <optional>

// Solids whose parts' surfaces nowhere meet, as thin shells: each part is meshed alone, as if the
// others were not there, so that cells are as large as its own shape lets them be, however thin the
// wall is.

namespace zeroset {

/// A length, that of boxes in which no two parts' surfaces are any more: the order of the distance
/// between them. Nothing where surfaces of parts or cuts meet, or are too close to tell. In upward
/// rounding.
std::optional<double> gap_between_parts(const MeshSolid& solid, const MeshWork& work);

/// The mesh of a solid whose parts lie apart by such a length, of meshes of each part alone.
/// Nothing where one of them ends at what is not its own.
std::optional<MadeMesh> mesh_of_parts(const MeshSolid& solid, const MeshOptions& options,
                                      double gap);

}  // namespace zeroset
