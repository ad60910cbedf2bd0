#pragma once

#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"

namespace zeroset::ui {

/// Draws the status line along the window's bottom: at the left facts about the point under the
/// pointer, else time, size and certificates of the picture; at the right the keys, if there is
/// room. Edits nothing.
void draw_status_panel(const Edited& edited, const Shown& shown);

}  // namespace zeroset::ui
