#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the settings of surface colours: the coloured quantity, colour map, range, and marks of
/// undecided pixels. Edits the document's `coloring` and `mark_undecided`.
void draw_look_section(UiState& state);
/// Height of the section's contents in window coordinates.
float look_section_height(const UiState& state);

}  // namespace zeroset::ui
