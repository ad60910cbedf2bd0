#pragma once

#include "engine/view/camera.hpp"
#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_float2.hpp>

#include <array>

namespace zeroset::ui {

/// One end of an axis of the world as it shows in the gizmo.
struct GizmoBall {
    int axis = 0;  ///< 0, 1, 2: x, y, z
    bool positive = true;
    glm::dvec2 at{0.0};     ///< to the right and upwards, 1 at the gizmo's rim
    double nearness = 0.0;  ///< towards the eye, -1 to 1

    [[nodiscard]] glm::dvec3 outward() const {
        glm::dvec3 direction(0.0);
        direction[axis] = positive ? 1.0 : -1.0;
        return direction;
    }
};

/// The six ends, the farthest first.
std::array<GizmoBall, 6> gizmo_balls(const Camera& camera);

/// Where a ball of the gizmo stands, window coordinates.
glm::vec2 gizmo_place(const GizmoBall& ball);

/// Puts the current window, which lies over the picture, under all pages and panels.
void put_under_pages();

/// The axes of the world in the picture's upper right corner: a click on an end looks from there, a
/// second one from the other end; a drag turns the view. Nothing where the picture is small.
void draw_axis_gizmo(UiState& state);

}  // namespace zeroset::ui
