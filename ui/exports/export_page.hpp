#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Closes the page by Escape and saves by Enter, unless something else takes the keyboard; to be
/// called before the text fields of the frame.
void follow_export_keys(UiState& state);

/// Draws the page if it is open, and how far an export is.
void draw_export_page(UiState& state);

/// Draws what the file will look like, at the current line.
void draw_export_preview(UiState& state);
/// Draws what is known of the file, at the current line.
void draw_export_facts(const UiState& state);

}  // namespace zeroset::ui
