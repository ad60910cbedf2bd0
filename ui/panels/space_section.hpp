#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the settings of space: axes, clip box and grid, views along the axes, the up direction and
/// how dragging turns the view.
void draw_space_section(UiState& state);
/// Height of the section's contents in window coordinates.
float space_section_height();

}  // namespace zeroset::ui
