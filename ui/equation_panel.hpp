#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// The bar along the window's top: the equation's text field, the gallery and, below, how the
/// equation was read or what is wrong with it, marked under its character. Edits `equation` and
/// `surface`. A long error makes the bar grow over the picture.
void draw_equation_panel(UiState& state);

/// Height of the bar when it does not have to grow, window coordinates.
float equation_bar_height();

}  // namespace zeroset::ui
