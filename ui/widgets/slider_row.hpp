#pragma once

#include "document/document.hpp"

#include <string>

namespace zeroset::ui {

/// A label; the control that follows fills the rest of the line. A long label is cut.
void draw_label(const std::string& label, const std::string& explanation);

/// The rest of a line: an integer slider and, at its right, `shown` or the number if it is null.
/// True when it was moved.
bool draw_integer_slider(const char* id, int& value, int lo, int hi, const char* shown);

/// The rest of a line but for `right` at its end (window coordinates): the slider and its value.
/// Ctrl+click or double-click on it, or a click on the value, types a number, beyond the ends, too:
/// it moves them. A right click sets all to `usual`.
void draw_slider(const char* id, Slider& slider, const Slider& usual, float right);

}  // namespace zeroset::ui
