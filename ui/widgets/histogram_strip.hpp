#pragma once

#include "document/document.hpp"
#include "engine/volume/histogram.hpp"
#include "ui/style/theme.hpp"

namespace zeroset::ui {

/// Draws how often samples have the values of a slider's range, as columns whose heights are
/// logarithms, and a line at the slider's value; a press or drag sets the value. `width`: in window
/// coordinates.
void draw_histogram(const char* id, const Histogram& histogram, Slider& slider, float width,
                    const Palette& colors);

}  // namespace zeroset::ui
