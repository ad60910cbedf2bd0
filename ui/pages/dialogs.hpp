#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the question or the file choice there is. Escape gives up.
void draw_dialogs(UiState& state);

}  // namespace zeroset::ui
