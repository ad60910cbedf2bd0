#pragma once

#include "engine/view/camera.hpp"

#include <cstdint>

namespace zeroset {

// Ways to another view. Each returns the changed camera and keeps the other properties.

/// Where one looks from. Corner: from the right, in front and above, all three alike.
enum class Side : std::uint8_t { Front, Back, Right, Left, Top, Bottom, Corner };

/// The direction from what is looked at to the eye; length 1.
glm::dvec3 outward(Side side, const glm::dvec3& up);

/// Looks at the same point against the direction `outward`, at the same distance. `up` is up in the
/// picture; from straight above it is what lies behind for one who looks from the front, from
/// straight below what lies in front.
Camera seen_from(const Camera& camera, const glm::dvec3& outward, const glm::dvec3& up);

/// As orbit, about `up`, which becomes the camera's. From straight above and below, too; what is up
/// in the picture there stays up.
Camera orbit_about(const Camera& camera, const glm::dvec3& up, double yaw_rad, double pitch_rad);

/// Turns as a ball about the point looked at does, of the image's height, that is grabbed at `from`
/// and let go at `to`; beyond its rim it rolls about the view. In heights of the image from its
/// centre, to the right and upwards. Turns the camera's `up`, too.
Camera roll_ball(const Camera& camera, const glm::dvec2& from, const glm::dvec2& to);

/// Looks at `point` along the same direction; what is there keeps its size. Keeps the camera where
/// the point is not before the eye.
Camera centred(const Camera& camera, const glm::dvec3& point);

/// On the way from one camera to another, `part` from 0 to 1: straight for the point looked at,
/// even for directions, by equal factors for the distance. At 1 it is `to`.
Camera between(const Camera& from, const Camera& to, double part);

}  // namespace zeroset
