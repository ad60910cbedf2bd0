#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// The settings of space: axes, clip box and grid, views from the axes, what is up and how dragging
/// turns.
void draw_space_section(UiState& state);
/// Its height, window coordinates.
float space_section_height(const UiState& state);

}  // namespace zeroset::ui
