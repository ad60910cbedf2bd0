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

/// Returns the slider of w or of a parameter; first_slider returns its initial settings.
Slider slider_named(const Document& document, const std::string& name);
Slider first_slider(const std::string& name);
/// Stores the slider in the document; a parameter's slider with its initial settings is removed
/// from it.
void set_slider(Document& document, const std::string& name, const Slider& slider);

}  // namespace zeroset::ui
