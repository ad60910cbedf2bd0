#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// The line along the window's bottom: at the left what is under the pointer, else time, size and
/// certificates of the picture; the keys at the right where there is room. Edits nothing.
void draw_status_panel(const UiState& state);

}  // namespace zeroset::ui
