#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// What lies over the picture in a presentation: the sliders that the document chose for it, and
/// unless the session is read-only a faint button that leaves it.
void draw_presentation(UiState& state);

}  // namespace zeroset::ui
