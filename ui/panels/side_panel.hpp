#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws the panel at the window's left: the document's menu and buttons at the top, below them the
/// list of statements with their sliders, then the sections of settings. Its right edge can be
/// dragged; when it is folded, only a button over the picture is left.
void draw_side_panel(UiState& state);

}  // namespace zeroset::ui
