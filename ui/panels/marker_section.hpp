#pragma once

#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"

namespace zeroset::ui {

/// Draws the list of markers with coordinates, to the digits that their labels in the picture have,
/// and distances from the selected one. Markers can be selected, copied and removed. Edits the
/// document's `markers` and `selected_marker`.
void draw_marker_section(Edited& edited, const ShownPicture& picture);
/// Height of the section's contents in window coordinates.
float marker_section_height(const Document& document);

}  // namespace zeroset::ui
