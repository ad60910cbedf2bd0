#pragma once

#include "engine/view/camera.hpp"
#include "engine/view/navigation.hpp"
#include "ui/model/steering.hpp"
#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

namespace zeroset::ui {

/// Duration of a move to another view, in seconds.
inline constexpr double view_move_s = 0.18;

/// Moves the document's camera smoothly to `camera`, from its current place if another move is
/// under way.
void move_view(UiState& state, const Camera& camera);
/// Advances the move under way; called once per frame. The move ends after view_move_s, or as soon
/// as anything else changes the camera.
void follow_move(UiState& state, double elapsed_s);

// Each of these moves starts where a move under way would end. None does anything without a camera.

/// Looks in the direction opposite to `outward`.
void look_from(UiState& state, const glm::dvec3& outward);
void look_from(UiState& state, Side side);
/// True if the view, or the end of the move under way, already looks opposite to `outward`.
bool looks_from(const UiState& state, const glm::dvec3& outward);
void look_from_opposite(UiState& state);
void centre_on(UiState& state, const glm::dvec3& point);
/// Sets the up direction and turns the view upright.
void set_up(UiState& state, const glm::dvec3& up);
/// Chooses between turning freely and turning upright; the latter turns the view upright first.
void set_trackball(UiState& state, bool freely);

// These small steps happen at once, without a smooth move.

/// Orbits the eye by steps of 15 degrees to the right and upwards.
void orbit_step(UiState& state, const glm::ivec2& steps);
/// Zooms in by so many notches of the wheel.
void zoom_step(UiState& state, double notches);

}  // namespace zeroset::ui
