#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// The settings of the view: search depth, clip box, shadows, first view and theme. Edits the
/// document's `stop`, `clip`, `shadows` and `antialias`, `theme` and `reset_view`.
void draw_view_section(UiState& state);
/// Its height, window coordinates.
float view_section_height(const UiState& state);

/// `box` about its own centre with its longest edge scaled to 2 * half.
Box resized(const Box& box, double half);

}  // namespace zeroset::ui
