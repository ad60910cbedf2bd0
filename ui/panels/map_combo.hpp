#pragma once

#include "engine/image/color_map.hpp"

#include <optional>

namespace zeroset::ui {

/// Draws a list of the color maps, by their colours and names, over the line's rest but `right`
/// (window coordinates). Returns the one that was chosen now.
std::optional<ColorMap> draw_map_combo(const char* id, ColorMap shown, float right = 0.0F);

}  // namespace zeroset::ui
