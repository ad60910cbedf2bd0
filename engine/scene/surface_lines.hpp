#pragma once

#include "engine/kernel/kernel.hpp"

#include <glm/glm.hpp>

#include <vector>

namespace zeroset {

/// A number at each point of the world: a coordinate, dot(along, point), or what code computes.
struct PointNumber {
    glm::dvec3 along{0.0};
    PointFunction code = {};  ///< none: the coordinate

    bool operator==(const PointNumber&) const = default;
};

/// Lines that are drawn on surfaces. A value.
struct SurfaceLines {
    /// Each number's contour lines: where it is a whole multiple of `step`.
    std::vector<PointNumber> contours;
    double step = 1.0;           ///< above 0
    float width_px = 1.4F;       ///< of all lines, as one looks straight at them; above 0
    bool labels = false;         ///< contour lines have their numbers, in what lies over pictures
    bool intersections = false;  ///< where two surfaces meet

    bool operator==(const SurfaceLines&) const = default;
    [[nodiscard]] bool any() const { return !contours.empty() || intersections; }
};

}  // namespace zeroset
