#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// The list of markers: each with its coordinates and its distance from the selected one; to
/// select, copy and remove. Edits the document's `markers` and `selected_marker`.
void draw_marker_section(UiState& state);
/// Its height, window coordinates.
float marker_section_height(const UiState& state);

}  // namespace zeroset::ui
