#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// The panel at the window's left: the document's menu and the buttons above, then one section
/// below the other: statements with their sliders, settings of the view. Its right edge can be
/// dragged; folded, only a button is left over the picture.
void draw_side_panel(UiState& state);

}  // namespace zeroset::ui
