#pragma once

#include "document/shown_point.hpp"
#include "ui/model/clip_handles.hpp"
#include "ui/model/edited.hpp"
#include "ui/model/shown.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/screen_areas.hpp"

#include <glm/ext/vector_double2.hpp>

#include <optional>

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Axes, clip box and grid, as far as they are wanted, over the picture that is shown between `lo`
/// and `hi` (window coordinates).
void draw_axes(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi, const Edited& edited,
               const ShownPicture& picture);

/// Right after the item that the picture is: the handle under the pointer or held by it, which the
/// pointer then has nothing else to do with. A drag edits the document's `clip` and `region`; Esc
/// gives it up. `cursor` as in PointerMotion.
std::optional<Handle> follow_clip_handles(UiState& state, const PictureArea& area,
                                          const ViewPoint& cursor);

/// The handles over the picture, as far as they are shown (see has_clip_handles); `lit`: what
/// follow_clip_handles gave.
void draw_clip_handles(ImDrawList& canvas, const PictureArea& area, const UiState& state,
                       const std::optional<Handle>& lit);

/// The handles as they stand in the picture, which is `height` high in window coordinates.
std::vector<Handle> shown_handles(const UiState& state, float height);

/// Right after the item that the picture is: moves the point that is held, or grabs the one below
/// the cursor. Returns that point.
std::optional<ShownPoint> follow_points(UiState& state, const PictureArea& area,
                                        const ViewPoint& cursor);

/// Draws a ring about the point that the pointer has, and says where it is while it is held.
void draw_held_point(ImDrawList& canvas, const PictureArea& area, const UiState& state,
                     const std::optional<ShownPoint>& point);

/// Whether the other tracer's picture is shown over a part of the picture.
bool has_divider(const UiState& state);

/// Draws the other tracer's picture over its part of the picture, or the difference over all of it.
void draw_other_picture(ImDrawList& canvas, const PictureArea& area, const UiState& state);

/// The divider between the two pictures, which can be dragged, and the names of their tracers. In
/// the window of the picture, before its own item.
void draw_divider(UiState& state, const PictureArea& area);

}  // namespace zeroset::ui
