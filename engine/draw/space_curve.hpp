#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace zeroset {

struct CurvePoint {
    glm::dvec3 place;
    glm::dvec3 tangent;  ///< of length 1, along the curve
};

/// A curve in space by points on it, near enough to each other that those between are found by
/// CurveSystem. A closed one does not repeat its first point.
struct SpaceCurve {
    std::vector<CurvePoint> points;
    bool closed = false;
};

/// A curve's start for Newton's method at a share of the way from one point to the next: the cubic
/// of their places and tangents.
glm::dvec3 between(const CurvePoint& a, const CurvePoint& b, double share);

}  // namespace zeroset
