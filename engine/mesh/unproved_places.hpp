#pragma once

#include "engine/mesh/cell_tree.hpp"
#include "engine/mesh/make_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// Groups of these leaves that touch one another, the largest first.
std::vector<UnprovedPlace> unproved_places(const CellTree& tree,
                                           std::span<const std::uint32_t> cells);

}  // namespace zeroset
