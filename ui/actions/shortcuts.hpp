#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Runs the actions whose keys were pressed, and counts mouse presses in `state.input.gesture`.
/// Called first in a frame, unless a dialog is open.
void follow_shortcuts(UiState& state);

}  // namespace zeroset::ui
