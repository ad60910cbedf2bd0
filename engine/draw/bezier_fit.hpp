#pragma once

#include "engine/draw/drawing.hpp"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace zeroset {

/// A point of a curve on the page with the curve's direction there, of length 1.
struct PagePoint {
    glm::dvec2 place;
    glm::dvec2 tangent;
};

glm::dvec2 point_of(const Bezier& curve, double t);

/// Cubic pieces through the first and the last point, with their directions where they meet, no
/// farther than `tolerance` from all points between [Schneider90]. At least two points.
std::vector<Bezier> fitted(std::span<const PagePoint> points, double tolerance);

}  // namespace zeroset
