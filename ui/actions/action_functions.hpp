#pragma once

#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_double3.hpp>

namespace zeroset::ui {

/// The error of a row, as its text is now; nullptr: there is none, or it is not read yet.
const RowError* error_of(const UiState& state, const Statement& statement);
/// Whether a row has an error at a place of its text.
bool has_errors(const UiState& state);
/// Puts the caret where the row is wrong.
void go_to_error(UiState& state, int row);
/// Puts the caret where the next row with an error is wrong, behind the row that is typed into.
void go_to_next_error(UiState& state);

/// Keeps a marker at the point, selects it, and moves the view so that the point is in the middle.
/// Where there are most_markers already, only the view moves.
void go_to(UiState& state, const glm::dvec3& point);

/// Opens the section of the markers, with the keyboard in the field into which a point is typed.
void ask_for_point(UiState& state);

/// Begins a presentation on the full screen, or ends it. A read-only session never ends it.
void switch_presentation(UiState& state);

/// Ends the presentation; in a read-only session only the full screen.
void leave_presentation(UiState& state);

/// True while there is something to be left and no page is open, whose Esc comes first.
bool can_leave_presentation(const UiState& state);

/// Makes letters larger by so many of letter_sizes, or smaller.
void change_letters(Layout& layout, int steps);

/// Runs the actions whose keys were pressed, and counts mouse presses in `state.input.gesture`.
/// Called first in a frame, unless a dialog is open.
void follow_shortcuts(UiState& state);

}  // namespace zeroset::ui
