#pragma once

#include "ui/model/clip_handles.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/style/screen_areas.hpp"

#include <glm/ext/vector_double2.hpp>

#include <optional>

namespace zeroset::ui {

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

}  // namespace zeroset::ui
