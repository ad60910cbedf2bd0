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

Turning turning_of(const UiState& state) {
    return {.up = state.document.up, .freely = state.document.trackball};
}

Camera steer(const Camera& camera, const PointerMotion& motion, const Turning& turning) {
    Camera moved = camera;
    if (motion.orbit != glm::dvec2(0.0)) {
        const glm::dvec2 angles = -orbit_rad * motion.orbit;
        moved = turning.freely ? roll_ball(moved, motion.cursor - motion.orbit, motion.cursor)
                               : orbit_about(moved, turning.up, angles.x, angles.y);
    }
    if (motion.pan != glm::dvec2(0.0)) moved = pan(moved, -motion.pan.x, -motion.pan.y);
    if (motion.wheel != 0.0) {
        const glm::dvec3 plane = point_under(moved, 2.0 * motion.cursor.x, 2.0 * motion.cursor.y);
        moved = zoom(moved, std::pow(zoom_per_notch, motion.wheel), motion.surface.value_or(plane));
    }
    return camera_defect(moved) == nullptr ? moved : camera;
}

}  // namespace zeroset::ui
