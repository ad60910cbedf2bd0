#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Runs the actions whose keys were pressed. Call first in a frame, and not while a dialog is open.
/// Also counts the gestures.
void follow_shortcuts(UiState& state);

}  // namespace zeroset::ui
