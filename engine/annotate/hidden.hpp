#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_int2.hpp>

namespace zeroset {

/// The pixel of a picture at a place in heights of it from its centre, x to the right, y upwards;
/// it may lie outside.
glm::ivec2 pixel_under(const Framebuffer& frame, const ViewPoint& place);

/// Whether a surface of the picture hides a point; or the eye does not look towards it.
bool is_behind(const Framebuffer& frame, const ViewFrame& view, const glm::dvec3& point);

/// The point at the middle of a ball, moved to just before the ball, which then does not hide it.
glm::dvec3 before_ball(const ViewFrame& view, const glm::dvec3& middle, double radius);

}  // namespace zeroset
