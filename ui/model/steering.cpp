#include "ui/model/steering.hpp"

#include "engine/view/navigation.hpp"

#include <cmath>
#include <numbers>

namespace zeroset::ui {
namespace {

/// A drag over the height of the picture turns by this much.
constexpr double orbit_rad = std::numbers::pi;
constexpr double zoom_per_notch = 0.88;

}  // namespace

TurnMode turn_mode_of(const Document& document) {
    return {.up = document.up, .freely = document.trackball};
}

Camera steer(const Camera& camera, const PointerMotion& motion, const TurnMode& turning) {
    Camera moved = camera;
    if (motion.orbit != ViewShift()) {
        moved = turning.freely ? roll_ball(moved, motion.cursor - motion.orbit, motion.cursor)
                               : orbit_about(moved, turning.up, -orbit_rad * motion.orbit.x,
                                             -orbit_rad * motion.orbit.y);
    }
    if (motion.pan != ViewShift()) moved = pan(moved, -motion.pan);
    if (motion.wheel != 0.0) {
        const glm::dvec3 plane = point_under(moved, motion.cursor);
        moved = zoom(moved, std::pow(zoom_per_notch, motion.wheel), motion.surface.value_or(plane));
    }
    return camera_defect(moved) == nullptr ? moved : camera;
}

}  // namespace zeroset::ui
