#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// Height of `rows` lines of readings, window coordinates.
float readings_height(int rows);

/// Each of `readings` on a line of its own, `rows` of them at a time, the others by scrolling. A
/// click on one offers to copy it.
void draw_readings(const UiState& state, int rows);

/// `error`, as long as it is: what is wrong in the error's colour, what is missing quietly.
void draw_error(const UiState& state);

}  // namespace zeroset::ui
