#pragma once

#include "document/document.hpp"
#include "engine/scene/palette.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// How the fronts of the palette show, 0xRRGGBB.
const std::vector<std::uint32_t>& palette_fronts();

/// The two sides of a surface whose front shows as `front` (0xRRGGBB): the palette's pair, or the
/// palette's back that differs most.
SurfaceColors surface_colors(std::uint32_t front);

/// Gives the rows that show a surface and have no colour one of the palette's that no other row
/// has, as long as there are such. Whether anything changed.
bool choose_colors(Document& document, const std::vector<int>& surface_rows);

}  // namespace zeroset
