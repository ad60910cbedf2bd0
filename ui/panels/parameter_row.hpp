#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// Draws a row for w if the text uses it, and for each of `state.parameters`: play button, slider
/// and a popup for range, step and speed. Edits the document's sliders and `playing`.
void draw_parameter_rows(UiState& state);

/// Returns the slider of w or of a parameter; first_slider returns its initial settings.
Slider slider_named(const UiState& state, const std::string& name);
Slider first_slider(const std::string& name);
/// Stores the slider in the document; a parameter's slider with its initial settings is removed
/// from it.
void set_slider(UiState& state, const std::string& name, const Slider& slider);

}  // namespace zeroset::ui
