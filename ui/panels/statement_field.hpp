#pragma once

#include "document/sheet.hpp"
#include "ui/model/ui_state.hpp"

#include <cstdint>
#include <string>

namespace zeroset::ui {

/// Outcome of one frame of a row's text field; mostly a key that the list must act on.
enum class FieldEvent : std::uint8_t {
    None,
    NextRow,  ///< Enter
    Up,       ///< Up in the first line
    Down,     ///< Down in the last line
    TabForward,
    TabBackward,
    DeleteBack,  ///< Backspace in an empty field
    DeleteAhead,
    MoveUp,  ///< Alt+Up
    MoveDown,
    Duplicate,  ///< Ctrl+D
    Paste,      ///< text of several lines was inserted at once
};

/// Height of a field of this width that shows `text`, whose long lines go on in the next line; in
/// window coordinates.
float statement_field_height(const std::string& text, float width);

/// Draws the text field of a row, with a mark at its error. Shift+Enter inserts a line break;
/// Escape leaves the field. Edits the statement's text, fulfils `state.wishes.focus` and
/// `state.wishes.reload` for this row, and sets `state.input.typing_row` while the field has the
/// keyboard.
FieldEvent draw_statement_field(UiState& state, Statement& statement, const RowError* error,
                                float width, const char* hint);

}  // namespace zeroset::ui
