#pragma once

#include "ui/style/theme.hpp"

#include <cstdint>

namespace zeroset::ui {

enum class Edge : std::uint8_t { Top, Bottom };

/// ImGui::Begin for a fixed bar with square corners along an edge of the window. The caller sets
/// its place and size by ImGui::SetNextWindow... calls; `flags` are additional ImGuiWindowFlags.
bool begin_bar(const char* name, const Palette& colors, int flags);
/// Ends the bar and draws a hairline along its edge `hairline`, which faces the picture.
void end_bar(Edge hairline, const Palette& colors);

}  // namespace zeroset::ui
