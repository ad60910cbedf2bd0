#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// The rows of the document's statements with a place to add one, then the sliders of parameters
/// and of w. Fills the window that it is drawn in.
void draw_statement_list(UiState& state);

/// Rows added to the document: of each statement of a text, after the row at `index`; the keyboard
/// goes to the last.
void insert_rows(UiState& state, std::size_t index, const std::string& text);

}  // namespace zeroset::ui
