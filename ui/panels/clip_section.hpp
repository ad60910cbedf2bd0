#pragma once

#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"
#include "ui/model/wishes.hpp"

namespace zeroset::ui {

/// Draws the settings of the clip region: box, sphere, sections. Edits the document's `clip` and
/// `region` and how sections show values; wishes to frame the box once a number of it is typed.
void draw_clip_section(Edited& edited, const Shown& shown, Wishes& wishes);
/// Height of the section's contents in window coordinates.
float clip_section_height(const Edited& edited);

/// Returns `box` scaled about its centre so that its longest edge is 2 * half.
Box resized(const Box& box, double half);

/// Returns the axis that the section is perpendicular to: 0 to 2, or 3 for any other direction.
int axis_of(const Section& section);
/// Returns a section perpendicular to `axis` through the box's centre or, for axis 3, perpendicular
/// to the view through the point looked at. It keeps the side away from the eye.
Section section_across(int axis, const Document& document);

}  // namespace zeroset::ui
