#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws a field into which a point is typed, the list of markers with coordinates, to the digits
/// that their labels in the picture have, and distances from the selected one, and the selected
/// one's label. Markers can be selected, copied, snapped to special points and removed. Edits the
/// document's `markers` and `selected_marker`.
void draw_marker_section(UiState& state);

/// Height of the section's contents in window coordinates.
float marker_section_height(const UiState& state);

}  // namespace zeroset::ui
