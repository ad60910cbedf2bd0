#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Escape closes the help and then does nothing else. First in a frame.
void follow_help_keys(UiState& state);

/// The help, while `show_help`: `language_help` as far as it has the words of `help_filter`, and
/// the keys. Takes no keyboard when it opens, so that typing goes on. Edits both.
void draw_help_panel(UiState& state);

}  // namespace zeroset::ui
