#pragma once

#include "ui/style/theme.hpp"

#include <cstdint>

namespace zeroset::ui {

enum class Edge : std::uint8_t { Top, Bottom };

/// ImGui::Begin for a fixed bar without corners along an edge of the window. Place and size come
/// from the usual ImGui::SetNextWindow... calls; `flags` are ImGuiWindowFlags to add.
bool begin_bar(const char* name, const Palette& colors, int flags);
/// Draws a hairline on the edge towards the picture and ends the bar.
void end_bar(Edge hairline, const Palette& colors);

}  // namespace zeroset::ui
