#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace zeroset::test {

struct CsgSphere {
    glm::dvec3 centre;
    double radius;

    /// Below 0 inside.
    [[nodiscard]] std::string text() const;
};

/// Spheres in the box [-1, 1]^3, the same for the same count, each of which is partly visible from
/// `eye`. They cover about as much of the picture whatever their number.
std::vector<CsgSphere> visible_spheres(int count, const glm::dvec3& eye);

/// `function(part, part, ...)`, or the only part.
std::string combined(const std::string& function, const std::vector<CsgSphere>& parts);

}  // namespace zeroset::test
