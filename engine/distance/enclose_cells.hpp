#pragma once

#include "engine/distance/near_surface.hpp"

#include <vector>

namespace zeroset {

/// Whether cells hold zeros, as far as enclosures tell.
struct EnclosedCells {
    std::vector<SurfacePiece> pieces;  ///< enclosed finely enough
    std::vector<Box> open;             ///< to be divided; all other cells hold no zero
};

/// Encloses the zeros in the cells, on all cores.
EnclosedCells enclose_cells(const SurfaceFunction& function, const std::vector<Box>& cells,
                            const SlabLimits& limits);

/// The eighths of the cells.
std::vector<Box> divided(const std::vector<Box>& cells);

}  // namespace zeroset
