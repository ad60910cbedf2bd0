#pragma once

#include "ui/model/ui_state.hpp"
#include "ui/style/screen_areas.hpp"

struct ImDrawList;

namespace zeroset::ui {

/// Whether the other tracer's picture is shown over a part of the picture.
bool has_divider(const UiState& state);

/// Draws the other tracer's picture over its part of the picture, or the difference over all of it.
void draw_other_picture(ImDrawList& canvas, const PictureArea& area, const UiState& state);

/// The divider between the two pictures, which can be dragged, and the names of their tracers. In
/// the window of the picture, before its own item.
void draw_divider(UiState& state, const PictureArea& area);

}  // namespace zeroset::ui
