#pragma once

namespace zeroset::ui {

struct UiState;

/// Height of the section's contents in window coordinates.
float camera_section_height(const UiState& state);

/// Draws the saved views, each with a small picture that a click goes to, and the camera as numbers
/// that can be typed.
void draw_camera_section(UiState& state);

}  // namespace zeroset::ui
