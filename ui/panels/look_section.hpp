#pragma once

#include "document/document.hpp"
#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"

namespace zeroset::ui {

/// Draws the settings of surface colours: the coloured quantity, colour map, range, contour
/// lines, and marks of undecided pixels. Edits the document's `coloring` and `mark_undecided`.
void draw_look_section(Edited& edited, const Shown& shown);
/// Height of the section's contents in window coordinates.
float look_section_height(const Document& document, const ReadingFacts& reading);

}  // namespace zeroset::ui
