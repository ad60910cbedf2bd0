#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the list of markers with coordinates and distances from the selected one. Markers can be
/// selected, copied and removed. Edits the document's `markers` and `selected_marker`.
void draw_marker_section(UiState& state);
/// Height of the section's contents in window coordinates.
float marker_section_height(const UiState& state);

}  // namespace zeroset::ui
