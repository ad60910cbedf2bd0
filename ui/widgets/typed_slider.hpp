#pragma once

#include <imgui/imgui.h>

// ImGui's sliders, but Tab goes to the slider itself, which the arrow keys then move, and a number
// is typed with a decimal point or a comma. Ctrl+click, Enter or type_into() let one type it.

namespace zeroset::ui {

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
