#pragma once

#include "document/sheet.hpp"
#include "ui/model/ui_state.hpp"

#include <cstdint>
#include <string>

namespace zeroset::ui {

/// What happened in a row's field during a frame.
enum class FieldEvent : std::uint8_t {
    None,
    NextRow,  ///< Enter
    Up,       ///< an arrow beyond the first line
    Down,     ///< or the last
    TabForward,
    TabBackward,
    DeleteBack,  ///< Backspace or Delete in an empty field
    DeleteAhead,
    MoveUp,  ///< Alt with an arrow
    MoveDown,
    Duplicate,  ///< Ctrl+D
    Paste,      ///< several lines arrived at once
};

/// Height of a field for this text, window coordinates.
float statement_field_height(const std::string& text);

/// The text field of a row, with the mark of its error. Shift+Enter begins a new line in it;
/// Escape leaves it. Edits the statement's text, fulfils `state.focus` and `state.reload` for this
/// row, and sets `state.typing_row` while it has the keyboard.
FieldEvent draw_statement_field(UiState& state, Statement& statement, const RowError* error,
                                float width, const char* hint);

}  // namespace zeroset::ui
