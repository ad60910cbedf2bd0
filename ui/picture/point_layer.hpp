#pragma once

#include "document/shown_point.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/screen_areas.hpp"

#include <optional>

struct ImDrawList;

namespace zeroset::ui {

/// Right after the item that the picture is: moves the point that is held, or grabs the one below
/// the cursor. Returns that point.
std::optional<ShownPoint> follow_points(UiState& state, const PictureArea& area,
                                        const ViewPoint& cursor);

/// Draws a ring about the point that the pointer has, and says where it is while it is held.
void draw_held_point(ImDrawList& canvas, const PictureArea& area, const UiState& state,
                     const std::optional<ShownPoint>& point);

}  // namespace zeroset::ui
