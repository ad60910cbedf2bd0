#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// The error of a row, as its text is now; nullptr: there is none, or it is not read yet.
const RowError* error_of(const UiState& state, const Statement& statement);
/// Whether a row has an error at a place of its text.
bool has_errors(const UiState& state);
/// Puts the caret where the row is wrong.
void go_to_error(UiState& state, int row);
/// Puts the caret where the next row with an error is wrong, behind the row that is typed into.
void go_to_next_error(UiState& state);

}  // namespace zeroset::ui
