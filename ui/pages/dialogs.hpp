#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the question or the file choice of `state.dialogs`, if there is one. Escape cancels it.
void draw_dialogs(UiState& state);

}  // namespace zeroset::ui
