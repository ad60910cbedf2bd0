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
};

/// `box` about its own centre, `factor` times as large.
Box scaled(const Box& box, double factor);

}  // namespace zeroset
