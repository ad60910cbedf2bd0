#pragma once

#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

#include <string>

namespace zeroset::ui {

/// A few words `gap` beside a dot in the picture, at the left of it where they would leave the
/// area.
void draw_tag(ImDrawList& canvas, const PictureArea& area, const ImVec2& dot, float gap,
              const std::string& text, float opacity, const Palette& colors);

}  // namespace zeroset::ui
