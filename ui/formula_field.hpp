#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// Height of the field that shows `lines` lines, window coordinates.
float formula_field_height(int lines);

/// Of `equation`, at least one; with the line that Enter begins in this frame, so that the field
/// has room for it and need not scroll.
int formula_lines(const UiState& state);

/// The text field of `equation`, with the mark of its error. Enter begins a new line; Tab and
/// Escape leave the field. It shows `lines` lines and scrolls to the others. Edits `equation`,
/// fulfils `focus_equation`.
void draw_formula_field(UiState& state, float width, int lines);

}  // namespace zeroset::ui
