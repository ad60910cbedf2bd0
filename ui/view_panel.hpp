#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// The card over the picture: parameters, search depth, clip box, view and theme. Edits
/// `parameters`, `w`, `stop`, `clip`, `theme` and `reset_view`.
void draw_view_panel(UiState& state);

/// `box` about its own centre with its longest edge scaled to 2 * half.
Box resized(const Box& box, double half);

}  // namespace zeroset::ui
