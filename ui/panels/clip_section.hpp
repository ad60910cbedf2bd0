#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// What is shown of space: the box, a sphere, sections. Edits the document's `clip` and `region`.
void draw_clip_section(UiState& state);
/// Its height, window coordinates.
float clip_section_height(const UiState& state);

/// `box` about its own centre with its longest edge scaled to 2 * half.
Box resized(const Box& box, double half);

/// The axis that a section is across: 0 to 2, or 3 for any other plane.
int axis_of(const Section& section);
/// A section across an axis through the middle of the box, or, for 3, across the view through the
/// point looked at. It keeps the side away from the eye.
Section section_across(int axis, const Document& document);

}  // namespace zeroset::ui
