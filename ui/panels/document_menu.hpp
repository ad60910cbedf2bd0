#pragma once

#include "ui/model/ui_state.hpp"
#include "ui/style/icons.hpp"

namespace zeroset::ui {

/// Draws the button that opens the document menu: new, open, recent files, save, copy, paste. Sets
/// `state.wishes.command` and `state.wishes.open_path`.
void draw_document_menu(UiState& state, const IconLook& look);

}  // namespace zeroset::ui
