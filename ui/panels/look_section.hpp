#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// What the colours of the surfaces tell, their map and range, and the marks of undecided pixels.
/// Edits the document's `coloring` and `mark_undecided`.
void draw_look_section(UiState& state);
/// Its height, window coordinates.
float look_section_height(const UiState& state);

}  // namespace zeroset::ui
