#pragma once

#include "engine/view/camera.hpp"

namespace zeroset {

/// The lightness of a cap at a point, as a part of its surface's colour: less than 1, and less
/// again on the lines of a fine hatch.
float cap_tone(const ViewFrame& view, int height_px, const glm::dvec3& point,
               const glm::dvec3& normal);

}  // namespace zeroset
