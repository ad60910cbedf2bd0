#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the settings of the view: search depth, projection, shadows, first view and theme. Edits
/// the document's `stop`, `camera`, `shadows` and `antialias`, and `theme` and `reset_view`.
void draw_view_section(UiState& state);
/// Height of the section's contents in window coordinates.
float view_section_height();

}  // namespace zeroset::ui
