#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// A slider for w where the text has it and for each of `parameters`; nothing where there are none.
/// The rows that do not fit into a height of `room` are reached by scrolling; where `room` is too
/// low even for that, all of them are drawn. Edits `w`, `parameters` and the ends of their sliders.
void draw_parameters(UiState& state, float room);

}  // namespace zeroset::ui
