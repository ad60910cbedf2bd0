#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws a row for each statement of the document, a button that adds one, then the sliders of
/// parameters and w. Fills the current ImGui window.
void draw_statement_list(UiState& state);

/// Inserts a row for each statement of a text after the row at `index`; the keyboard goes to the
/// last new row.
void insert_rows(UiState& state, std::size_t index, const std::string& text);

}  // namespace zeroset::ui
