#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws what the file will look like, at the current line.
void draw_export_preview(UiState& state);

}  // namespace zeroset::ui
