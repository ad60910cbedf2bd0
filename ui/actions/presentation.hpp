#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Begins a presentation on the full screen, or ends it. A read-only session never ends it.
void switch_presentation(UiState& state);

/// Ends the presentation; in a read-only session only the full screen.
void leave_presentation(UiState& state);

/// True while there is something to be left and no page is open, whose Esc comes first.
bool can_leave_presentation(const UiState& state);

/// Makes letters larger by so many of letter_sizes, or smaller.
void change_letters(Layout& layout, int steps);

}  // namespace zeroset::ui
