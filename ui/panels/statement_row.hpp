#pragma once

#include "ui/model/ui_state.hpp"

#include <cstddef>
#include <cstdint>

namespace zeroset::ui {

/// What is to be done with a row, or has the keyboard leave it.
enum class RowEvent : std::uint8_t {
    None,
    Next,  ///< a new row after this one
    FocusUp,
    FocusDown,
    FocusNext,  ///< Tab
    FocusPrevious,
    RemoveBack,  ///< and go on at the end of the row before
    RemoveAhead,
    MoveUp,
    MoveDown,
    Duplicate,
    Split,  ///< its text may be several statements
};

/// One row of the list: grip, swatch, text, eye, cross, and below them how it was read or what is
/// wrong with it. `hint` stands in its field while that is empty, or nullptr. Edits
/// state.document.statements[index].
RowEvent draw_statement_row(UiState& state, std::size_t index, const char* hint);

}  // namespace zeroset::ui
