#pragma once

#include "document/document.hpp"
#include "document/sheet.hpp"
#include "ui/actions/action_functions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>

namespace zeroset::ui {

/// Everything that the parts of a row need for drawing.
struct Row {
    UiState& state;
    Statement& statement;
    const RowReport* report;  ///< nullptr: not read yet
    const Palette& colors;
    ImRect place;  ///< from the previous frame, to find the row under the pointer
    bool hovered;
    bool typing;

    [[nodiscard]] bool is_surface() const {
        return std::ranges::find(state.shown.reading.surface_rows, statement.id) !=
               state.shown.reading.surface_rows.end();
    }
    /// Error of the row's current text; nullptr if there is none or it is not read yet.
    [[nodiscard]] const RowError* error() const { return error_of(state, statement); }
    /// True where it is wrong, and not only because it is still being typed.
    [[nodiscard]] bool is_broken() const {
        return error() != nullptr && !(error()->unfinished && typing);
    }
};

/// Draws below a row's field how it was read, or what is wrong. A click on a reading shows all of
/// it.
void draw_row_answer(const Row& row, float width);

}  // namespace zeroset::ui
