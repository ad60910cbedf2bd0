#pragma once

#include "ui/model/ui_state.hpp"

#include <cstddef>
#include <cstdint>

namespace zeroset::ui {

/// Action that the list must take for a row, or the row that gets the keyboard next.
enum class RowEvent : std::uint8_t {
    None,
    Next,  ///< insert a new row after this one
    FocusUp,
    FocusDown,
    FocusNext,  ///< Tab: the next row gets the keyboard
    FocusPrevious,
    RemoveBack,  ///< remove the row and continue at the end of the row before
    RemoveAhead,
    MoveUp,
    MoveDown,
    Duplicate,
    Split,  ///< divide the row: its text may contain several statements
};

/// Draws one row of the list: grip, swatch, text, eye, cross, and below them its readings or its
/// error. `hint` is shown in an empty field; nullptr: no hint. Edits
/// state.edited.document.statements[index].
RowEvent draw_statement_row(UiState& state, std::size_t index, const char* hint);

}  // namespace zeroset::ui
