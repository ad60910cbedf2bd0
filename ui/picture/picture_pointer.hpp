#pragma once

#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_double2.hpp>

namespace zeroset::ui {

/// Right after the item that the picture is: sets `state.input.pointer`, and `state.wishes.click`
/// where a press was no drag. `cursor` as in PointerMotion.
void follow_picture_pointer(UiState& state, const ViewPoint& cursor);

}  // namespace zeroset::ui
