#pragma once

#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_double2.hpp>

struct ImDrawList;
struct ImVec2;

namespace zeroset::ui {

/// Right after the item that the picture is: sets `state.pointer`, and `state.click` where a press
/// was no drag. `cursor` as in PointerMotion.
void follow_picture_pointer(UiState& state, const glm::dvec2& cursor);

/// What stands over the picture: markers and the legend. (lo, hi): its area, window coordinates.
void draw_picture_marks(ImDrawList& canvas, const ImVec2& lo, const ImVec2& hi,
                        const UiState& state);

}  // namespace zeroset::ui
