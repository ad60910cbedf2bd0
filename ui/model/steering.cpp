#include "ui/model/steering.hpp"

#include "document/framing.hpp"
#include "engine/view/navigation.hpp"

#include <cmath>
#include <numbers>

namespace zeroset::ui {
namespace {

/// A drag over the height of the picture turns by this much.
constexpr double orbit_rad = std::numbers::pi;
constexpr double zoom_per_notch = 0.88;
/// The ways of a notch, in heights of the picture.
constexpr double orbit_per_notch = 1.0 / 24.0;
constexpr double pan_per_notch = 1.0 / 16.0;

/// The use of the wheel while these keys are held.
WheelUse use_with_keys(WheelUse use, bool ctrl, bool shift) {
    if (use == WheelUse::Zoom || ctrl) return WheelUse::Zoom;
    if (!shift) return use;
    return use == WheelUse::Orbit ? WheelUse::Pan : WheelUse::Orbit;
}

}  // namespace

TurnMode turn_mode_of(const Document& document) {
    return {.up = document.up, .freely = document.trackball};
}

PointerMotion scrolled(WheelUse use, double x, double y, bool ctrl, bool shift) {
    PointerMotion motion;
    switch (use_with_keys(use, ctrl, shift)) {
        case WheelUse::Zoom: motion.wheel = y; break;
        case WheelUse::Orbit:
            motion.orbit = {.x = orbit_per_notch * x, .y = -orbit_per_notch * y};
            break;
        case WheelUse::Pan: motion.pan = {.x = pan_per_notch * x, .y = -pan_per_notch * y}; break;
    }
    return motion;
}

Camera steer(const Camera& camera, const PointerMotion& motion, const TurnMode& turning) {
    Camera moved = fitting(camera, motion.aspect);
    if (motion.orbit != ViewShift()) {
        moved = turning.freely ? roll_ball(moved, motion.cursor - motion.orbit, motion.cursor)
                               : orbit_about(moved, turning.up, -orbit_rad * motion.orbit.x,
                                             -orbit_rad * motion.orbit.y);
    }
    if (motion.pan != ViewShift()) moved = pan(moved, -motion.pan);
    if (motion.wheel != 0.0 || motion.pinch != 1.0) {
        const glm::dvec3 plane = point_under(moved, motion.cursor);
        moved = zoom(moved, std::pow(zoom_per_notch, motion.wheel) / motion.pinch,
                     motion.surface.value_or(plane));
    }
    moved.fov_rad = camera.fov_rad;
    return camera_defect(moved) == nullptr ? moved : camera;
}

}  // namespace zeroset::ui
