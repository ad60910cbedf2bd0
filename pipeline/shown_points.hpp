#pragma once

#include "document/document.hpp"
#include "document/shown_point.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/formula.hpp"

#include <vector>

namespace zeroset {

/// The points among the rows that are shown in a picture of this height from this camera; none
/// without a formula.
std::vector<ShownPoint> shown_points(const Formula* formula, const Document& document,
                                     const Camera& camera, int height_px);

}  // namespace zeroset
