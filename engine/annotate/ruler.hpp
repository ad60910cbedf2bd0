#pragma once

#include "engine/annotate/outer_edges.hpp"
#include "engine/annotate/ticks.hpp"

#include <glm/ext/vector_double2.hpp>

#include <algorithm>
#include <cmath>

namespace zeroset {

/// The part [from, to] of the parameters 0 to 1.
struct VisiblePart {
    double from = 0.0, to = 1.0;

    /// Leaves where the linear function with these values at 0 and 1 is not below 0.
    void clip(double at_0, double at_1) {
        if (at_0 < 0 && at_1 < 0) to = -1.0;
        const double root = at_0 / (at_0 - at_1);
        if (at_0 < 0 && at_1 >= 0) from = std::max(from, root);
        if (at_0 >= 0 && at_1 < 0) to = std::min(to, root);
    }
    [[nodiscard]] bool empty() const { return !(from < to); }
};

/// A line along an axis, beside which its numbers stand.
struct Ruler {
    int axis = 0;
    Segment segment;
    VisiblePart part;
    glm::dvec2 aside;        ///< where the numbers are, across the line in the image; length 1
    double length_px = 0.0;  ///< of the part that is seen
    double length = 0.0;     ///< of that part, in the world

    [[nodiscard]] double px_per_unit() const { return length_px / length; }
    [[nodiscard]] double lowest() const { return segment.at(part.from)[axis]; }
    [[nodiscard]] double highest() const { return segment.at(part.to)[axis]; }
    /// Numbers of the first and the last tick in it.
    [[nodiscard]] double first(const TickStep& step) const {
        return std::ceil(lowest() / step.length() - 1e-9);
    }
    [[nodiscard]] double last(const TickStep& step) const {
        return std::floor(highest() / step.length() + 1e-9);
    }
};

}  // namespace zeroset
