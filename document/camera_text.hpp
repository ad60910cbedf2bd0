#pragma once

#include "engine/view/camera.hpp"

#include <expected>
#include <string>
#include <string_view>

// A camera as one line of text: "eye X,Y,Z; look-at X,Y,Z; up X,Y,Z; fov DEGREES", or with
// "height H" in place of fov for parallel rays, that show H world units from top to bottom at the
// point looked at.

namespace zeroset {

/// The vertical fields of view that can be typed, degrees.
inline constexpr double least_fov_deg = 0.01;
inline constexpr double most_fov_deg = 170.0;

/// All digits: read_camera_text reads the camera again, its angle to within a rounding.
std::string camera_text(const Camera& camera);

/// The camera of such a text, the parts in any order; what it leaves out is as in `base`. `eye` is
/// needed. Or one clause on what is wrong: "it says no eye X,Y,Z".
std::expected<Camera, std::string> read_camera_text(std::string_view text, const Camera& base);

/// Whether the text begins as one of camera_text does, with a word for a part of the camera.
bool looks_like_camera(std::string_view text);

}  // namespace zeroset
