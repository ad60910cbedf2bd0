#pragma once

#include "document/document.hpp"
#include "engine/scene/palette.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The colours as which the fronts of the palette show, 0xRRGGBB.
const std::vector<std::uint32_t>& palette_fronts();

/// A colour 0xRRGGBB as "#RRGGBB", and read from that.
std::string color_text(std::uint32_t color);
std::optional<std::uint32_t> color_from(std::string_view text);

/// Colours of the two sides of a surface whose front shows as `front` (0xRRGGBB): the palette's
/// pair, or for other fronts a paler tone of them, for light ones a deeper one.
SurfaceColors surface_colors(std::uint32_t front);

/// How the other side of such a surface shows, 0xRRGGBB.
std::uint32_t back_color(std::uint32_t front);

/// Gives each row of `surface_rows` without a colour one of the palette's that no other row has,
/// or, where all are taken, one in turn. Returns whether anything changed.
bool choose_colors(Document& document, const std::vector<int>& surface_rows);

}  // namespace zeroset
