#pragma once

#include "document/document.hpp"
#include "ui/style/theme.hpp"

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// The colour of a surface as a disc; a ring where the surface is hidden.
void draw_color_dot(ImDrawList& canvas, const ImVec2& centre, float radius,
                    const Statement& statement, const Palette& colors, bool hovered);

/// The popup `id`, if it is open: the palette's colours and any other, and the side that is solid.
/// Edits both.
void draw_surface_popup(const char* id, Statement& statement, const Palette& colors);

}  // namespace zeroset::ui
