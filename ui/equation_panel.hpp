#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// The bar along the window's top: the text field, the gallery, the help's button and, below, how
/// the text was read or what is wrong with it. Edits `equation`, `surface` and `show_help`. The bar
/// grows with the lines of the text and of its readings; a long error makes it grow further, over
/// the picture.
void draw_equation_panel(UiState& state);

/// Height of the bar without a long error, window coordinates. It does not change while a text
/// with an error stands in for the last good one, so that the picture stays as it is.
float equation_bar_height(const UiState& state);

}  // namespace zeroset::ui
