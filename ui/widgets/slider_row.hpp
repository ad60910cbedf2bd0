#pragma once

#include "document/document.hpp"

#include <imgui/imgui.h>

#include <string>

namespace zeroset::ui {

/// Width of the labels in front of controls, in em.
inline constexpr float label_width = 4.1F;

/// Draws a label, cut where it is too long; the control that follows fills the rest of the line.
void draw_label(const std::string& label, const std::string& explanation,
                float width_em = label_width);

/// An integer slider that fills the rest of the line, with `shown`, or the number if it is null, at
/// its right. Returns true when it was moved.
bool draw_integer_slider(const char* id, int& value, int lo, int hi, const char* shown);

/// The width of draw_slider's slider itself, in window coordinates.
float slider_width(float right);

/// A slider with its value, which fills the rest of the line except `right` (window coordinates) at
/// its end. Ctrl+click or double-click on the slider, or a click on the value, lets one type a
/// number; a number beyond an end moves that end. A right click sets the whole slider to `usual`.
void draw_slider(const char* id, Slider& slider, const Slider& usual, float right);

// ImGui's sliders, but Tab goes to the slider itself, which the arrow keys then move, and a number
// is typed with a decimal point or a comma. Ctrl+click, Enter or type_into() let one type it.

/// A slider that fills the next item's width, from `lo` to `hi`; `format` as for ImGui's sliders.
/// Text that is no number leaves the value alone, and with ImGuiSliderFlags_AlwaysClamp a number
/// beyond an end becomes that end. Returns true when the value changed.
bool slide(const char* id, double& value, double lo, double hi, const char* format,
           ImGuiSliderFlags flags = 0);
/// A slider for whole numbers; another number is no number.
bool slide(const char* id, int& value, int lo, int hi, const char* format,
           ImGuiSliderFlags flags = 0);

/// Turns the slider into a text field in the next frame.
void type_into(ImGuiID slider);

/// True while the arrow keys are what moves the slider.
bool is_moved_by_keys(ImGuiID slider);

}  // namespace zeroset::ui
