#pragma once

#include "engine/view/camera.hpp"
#include "engine/view/navigation.hpp"
#include "ui/model/steering.hpp"
#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

namespace zeroset::ui {

/// Seconds that a move to another view takes.
inline constexpr double view_move_s = 0.18;

/// Moves the document's camera to `camera`, smoothly; from where it is, if another move is under
/// way.
void move_view(UiState& state, const Camera& camera);
/// Goes on with the move under way. Call once a frame. It ends at its time, and at once when
/// anything else changes the camera.
void follow_move(UiState& state, double elapsed_s);

// Moves, each from where a move under way ends. Nothing happens without a camera.

/// To look against `outward`.
void look_from(UiState& state, const glm::dvec3& outward);
void look_from(UiState& state, Side side);
/// Whether that is the view already.
bool looks_from(const UiState& state, const glm::dvec3& outward);
void look_from_opposite(UiState& state);
void centre_on(UiState& state, const glm::dvec3& point);
/// Sets what is up, and turns the picture so.
void set_up(UiState& state, const glm::dvec3& up);
/// Turning freely or not; the picture is turned upright where it is not.
void set_trackball(UiState& state, bool freely);

// Small steps, at once.

/// In steps to the right and upwards, as seen by the eye.
void orbit_step(UiState& state, const glm::ivec2& steps);
/// Comes nearer by some notches of the wheel.
void zoom_step(UiState& state, double notches);

}  // namespace zeroset::ui
