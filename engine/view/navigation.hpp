#pragma once

#include "engine/view/camera.hpp"

#include <cstdint>

namespace zeroset {

// Changes of the view. Each function returns the changed camera and keeps its other properties.

/// Sides to look from. Corner: from the right, the front and above in equal parts.
enum class Side : std::uint8_t { Front, Back, Right, Left, Top, Bottom, Corner };

/// Unit vector from the point looked at to the eye, for a view from `side`.
glm::dvec3 outward(Side side, const glm::dvec3& up);

/// `camera` looking at the same point against the direction `outward`, at the same distance. `up`
/// is up in the picture; from straight above, up is what lies behind for one who looks from the
/// front, from straight below what lies in front.
Camera seen_from(const Camera& camera, const glm::dvec3& outward, const glm::dvec3& up);

/// Orbits about `up`, which becomes the camera's. Works from straight above and below, too; what is
/// up in the picture there stays up.
Camera orbit_about(const Camera& camera, const glm::dvec3& up, double yaw_rad, double pitch_rad);

/// Turns the camera with a ball about the point looked at, as high as the image, that is grabbed at
/// `from` and released at `to`; beyond its rim it rolls about the view. The camera's `up` turns,
/// too.
Camera roll_ball(const Camera& camera, const ViewPoint& from, const ViewPoint& to);

/// `camera` looking at `point` in the same direction; what is there keeps its size. Unchanged where
/// the point is not in front of the eye.
Camera centred(const Camera& camera, const glm::dvec3& point);

/// The camera between two others, `part` of the way from 0 to 1: the point looked at moves
/// straight, the directions turn evenly, the distance changes by equal factors. At 1 it is `to`.
Camera between(const Camera& from, const Camera& to, double part);

/// How much the camera shows from top to bottom at the point looked at, world units.
double shown_height(const Camera& camera);
/// `camera` with the angle by which it shows this much, above 0, there.
Camera with_shown_height(const Camera& camera, double height);

}  // namespace zeroset
