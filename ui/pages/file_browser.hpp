#pragma once

#include "ui/model/dialog_state.hpp"
#include "ui/style/theme.hpp"

namespace zeroset::ui {

/// Draws the file browser: folders and files of a folder, and a field for the name. Sets the
/// chosen path and `finished`.
void draw_file_browser(FileChoice& choice, const Palette& colors);

}  // namespace zeroset::ui
