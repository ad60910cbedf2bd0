#pragma once

#include "engine/view/box.hpp"

#include <cstdint>
#include <vector>

namespace zeroset {

/// The cells of a regular grid over a box in which a surface may be. Elsewhere in the box it surely
/// is not, for any values of the uniforms within the enclosures that it was found for.
struct OpenSpace {
    Box box;
    int side = 1;                      ///< cells along each axis
    std::vector<std::uint32_t> cells;  ///< x + side (y + side z) of those cells
};

}  // namespace zeroset
