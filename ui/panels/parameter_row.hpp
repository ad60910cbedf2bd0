#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// A row for w where the text has it and for each of `state.parameters`: play button, slider and a
/// popup for its range, step and speed. Edits the document's sliders and `playing`.
void draw_parameter_rows(UiState& state);

/// The slider of w or of a parameter, and how it is at first.
Slider slider_named(const UiState& state, const std::string& name);
Slider first_slider(const std::string& name);
/// Keeps the slider in the document, or leaves it out where it is as at first.
void set_slider(UiState& state, const std::string& name, const Slider& slider);

}  // namespace zeroset::ui
