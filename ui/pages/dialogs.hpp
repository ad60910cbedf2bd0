#pragma once

#include "ui/model/dialog_state.hpp"
#include "ui/model/theme.hpp"

namespace zeroset::ui {

/// Draws the question or the file choice, if there is one. Escape cancels it.
void draw_dialogs(Dialogs& dialogs, Theme theme);

}  // namespace zeroset::ui
