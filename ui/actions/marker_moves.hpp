#pragma once

#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_double3.hpp>

namespace zeroset::ui {

/// Keeps a marker at the point, selects it, and moves the view so that the point is in the middle.
/// Where there are most_markers already, only the view moves.
void go_to(UiState& state, const glm::dvec3& point);

/// Opens the section of the markers, with the keyboard in the field into which a point is typed.
void ask_for_point(UiState& state);

}  // namespace zeroset::ui
