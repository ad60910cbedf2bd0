#pragma once

#include "document/document.hpp"
#include "engine/image/color_map.hpp"
#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"
#include "ui/model/ui_state.hpp"

#include <optional>
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

/// Draws how sections show values: map, level and window. Edits the document's `section_values`.
void draw_section_values(Document& document, const ShownPicture& picture);
/// The number of its rows: 0 where no section shows values.
float section_values_rows(const Document& document);

/// A checkbox that runs the action of this name, which must have a state to show.
void draw_action_switch(UiState& state, const char* label, const char* name);

/// Draws a list of the color maps, by their colours and names, over the line's rest but `right`
/// (window coordinates). Returns the one that was chosen now.
std::optional<ColorMap> draw_map_combo(const char* id, ColorMap shown, float right = 0.0F);

}  // namespace zeroset::ui
