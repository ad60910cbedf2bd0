#pragma once

#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"

#include <string>
#include <vector>

namespace zeroset::ui {

/// Draws a row for w if the text uses it, and for each of `reading.parameters`: play button, slider
/// and a popup for range, step and speed. Edits the document's sliders and `playing`.
void draw_parameter_rows(Edited& edited, const ReadingFacts& reading);

/// Names of the sliders that a presentation shows, in their order.
std::vector<std::string> presented_sliders(const Document& document, const ReadingFacts& reading);

/// Draws a row for each of presented_sliders: play button and slider.
void draw_presented_rows(Edited& edited, const ReadingFacts& reading);

}  // namespace zeroset::ui
