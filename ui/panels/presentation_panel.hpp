#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws over the picture of a presentation the sliders that the document chose for it, and unless
/// the session is read-only a faint button that leaves it.
void draw_presentation(UiState& state);

}  // namespace zeroset::ui
