#pragma once

#include "ui/ui_state.hpp"

namespace zeroset::ui {

/// The keys that work everywhere: documents, undo, folding. Call first in a frame, and not while a
/// dialog is open. Also counts the gestures.
void follow_shortcuts(UiState& state);

}  // namespace zeroset::ui
