#pragma once

#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/icons.hpp"

namespace zeroset::ui {

// The panels of the screen. Each has a source of its own.

/// Draws over the picture of a presentation the sliders that the document chose for it, and unless
/// the session is read-only a faint button that leaves it.
void draw_presentation(UiState& state);

/// Draws the panel at the window's left: the document's menu and buttons at the top, below them the
/// list of statements with their sliders, then the sections of settings. Its right edge can be
/// dragged; when it is folded, only a button over the picture is left.
void draw_side_panel(UiState& state);

/// Draws the status line along the window's bottom: at the left facts about the point under the
/// pointer, else time, size and certificates of the picture; at the right the keys, if there is
/// room. Edits nothing.
void draw_status_panel(const Edited& edited, const Shown& shown);

/// Draws the button that opens the document menu: new, open, recent files, save, copy, paste. Sets
/// `state.wishes.command` and `state.wishes.open_path`.
void draw_document_menu(UiState& state, const IconLook& look);

/// Draws a row for each statement of the document, a button that adds one, then the sliders of
/// parameters and w. Fills the current ImGui window.
void draw_statement_list(UiState& state);

/// Inserts a row for each statement of a text after the row at `index`; the keyboard goes to the
/// last new row.
void insert_rows(UiState& state, std::size_t index, const std::string& text);

}  // namespace zeroset::ui
