#pragma once

#include "engine/trace/camera.hpp"
#include "ui/texture.hpp"
#include "ui/ui_state.hpp"

#include <glm/ext/vector_double2.hpp>

namespace zeroset::ui {

/// What the pointer did over the picture during one frame. Lengths in heights of the picture, x to
/// the right, y upwards.
struct PointerMotion {
    glm::dvec2 orbit{0.0};
    glm::dvec2 pan{0.0};
    double wheel = 0.0;      ///< notches; positive comes nearer
    glm::dvec2 cursor{0.0};  ///< from the picture's centre
};

/// The camera after the motion: what is grabbed follows the pointer. Keeps the camera if the
/// motion would lead to one that sees nothing.
Camera steer(const Camera& camera, const PointerMotion& motion);

/// Fills the window between the bars with the picture, stretched if it is coarse; the pointer and
/// the key R change the view, U whether undecided pixels are marked. Draw it before the panels.
/// Sets `state.viewport_px`.
void draw_viewport(UiState& state, const Texture& picture);

}  // namespace zeroset::ui
