#pragma once

#include "ui/style/theme.hpp"

#include <imgui/imgui.h>

namespace zeroset::ui {

/// Draws a small picture of surfaces over a sky; three dots while there is none. `name`: OpenGL's
/// of its texture; 0: none.
void draw_thumbnail(unsigned int name, const ImVec2& lo, const ImVec2& hi, const Palette& colors);

}  // namespace zeroset::ui
