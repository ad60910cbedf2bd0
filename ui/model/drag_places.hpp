#pragma once

#include "engine/view/camera.hpp"
#include "engine/view/pixel_ray.hpp"

#include <glm/ext/vector_double3.hpp>

// Where things are that are dragged in the picture.

namespace zeroset::ui {

/// The point that shows at `place`, as far along the view as `point`.
glm::dvec3 across_view(const ViewFrame& view, const glm::dvec3& point, const ViewPoint& place);

/// A number of world units, to a power of ten that is no larger than a pixel there.
double rounded_to_pixel(double number, double pixel);

}  // namespace zeroset::ui
