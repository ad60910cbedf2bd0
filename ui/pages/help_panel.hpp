#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Closes the help on Escape, and hides that key press from everything else. Called first in a
/// frame.
void follow_help_keys(UiState& state);

/// Draws the help while `show_help`: the entries of `language_help` that match `help_filter`, and
/// the keys. It takes no keyboard when it opens, so that typing can go on. Edits `show_help` and
/// `help_filter`.
void draw_help_panel(UiState& state);

}  // namespace zeroset::ui
