#pragma once

#include "document/document.hpp"
#include "engine/view/camera.hpp"
#include "ui/model/edited.hpp"

#include <glm/ext/vector_double3.hpp>

#include <optional>

namespace zeroset::ui {

/// Motion of the pointer over the picture during one frame.
struct PointerMotion {
    ViewShift orbit;
    ViewShift pan;
    double wheel = 0.0;   ///< notches; positive comes nearer
    double pinch = 1.0;   ///< how far apart two fingers have moved, a factor; above 1 comes nearer
    double aspect = 1.0;  ///< the picture's width over its height
    ViewPoint cursor;
    /// Point that the picture shows under the cursor, world units; nothing: the background.
    std::optional<glm::dvec3> surface = std::nullopt;
};

/// How dragging turns.
struct TurnMode {
    glm::dvec3 up{0.0, 0.0, 1.0};  ///< stays up
    bool freely = false;           ///< unless it turns as a ball does
};

/// The motion of the view by a turn of the wheel, or a way of two fingers. `x`, `y` are notches, as
/// GLFW has them: what scrolls follows the fingers.
PointerMotion scrolled(WheelUse use, double x, double y, bool ctrl, bool shift);

/// The camera after the motion: what is grabbed follows the pointer. Keeps the camera if the
/// motion would lead to one that sees nothing.
Camera steer(const Camera& camera, const PointerMotion& motion, const TurnMode& turning);

/// How dragging turns the document's view.
TurnMode turn_mode_of(const Document& document);

}  // namespace zeroset::ui
