#pragma once

#include "ui/model/ui_state.hpp"

namespace zeroset::ui {

/// The tracer that draws, another one to compare it with, and what pixels cost.
void draw_advanced_section(UiState& state);
/// Height of the section's contents in window coordinates.
float advanced_section_height(const UiState& state);

}  // namespace zeroset::ui
