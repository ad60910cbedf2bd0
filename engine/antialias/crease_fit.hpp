#pragma once

#include "engine/antialias/half_square.hpp"
#include "engine/antialias/ray_stretches.hpp"
#include "engine/antialias/square_rays.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace zeroset {

/// The sheets that cover a square: one, or two that meet in a line.
struct Creased {
    /// The part of each sheet, and the ray that stands for it; of share 0: there is none.
    std::array<SquarePart, 2> parts;
    std::array<std::size_t, 2> rays;
    bool grazed = false;  ///< a ray grazes a sheet, which may end nearby
    bool bent = false;    ///< one sheet, whose normals differ: all rays should stand for it
};

/// The sheets through the first roots of a square's rays, if they are such. `half_side`: of the
/// square, in pixels.
std::optional<Creased> fit_crease(SquareRoots roots, double half_side);

}  // namespace zeroset
