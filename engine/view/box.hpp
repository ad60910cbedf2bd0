#pragma once

#include <glm/glm.hpp>

namespace zeroset {

/// Axis-aligned clip box in world units; lo < hi in each axis.
struct Box {
    glm::dvec3 lo{-2.0};
    glm::dvec3 hi{2.0};

    bool operator==(const Box&) const = default;

    /// The cube [-half, half]^3.
    static Box cube(double half) { return {.lo = glm::dvec3(-half), .hi = glm::dvec3(half)}; }
    [[nodiscard]] glm::dvec3 centre() const { return 0.5 * (lo + hi); }
    /// Longest edge: the "domain" that d_stop divides.
    [[nodiscard]] double size() const;
    /// Whether a point is in it, or no farther than `slack` beyond one of its faces' planes.
    [[nodiscard]] bool contains(const glm::dvec3& point, double slack = 0.0) const {
        return glm::all(glm::lessThanEqual(lo - slack, point)) &&
               glm::all(glm::lessThanEqual(point, hi + slack));
    }
};

/// `box` about its own centre, `factor` times as large.
Box scaled(const Box& box, double factor);

/// The box in a world that is drawn stretched (Camera).
inline Box stretched(const Box& box, const glm::dvec3& stretch) {
    return {.lo = stretch * box.lo, .hi = stretch * box.hi};
}

}  // namespace zeroset
