#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace zeroset::test {

struct CsgSphere {
    glm::dvec3 centre;
    double radius;

    /// The formula of the sphere, negative inside.
    [[nodiscard]] std::string text() const;
};

/// Spheres in the box [-1, 1]^3, equal for equal counts, each of which is partly visible from
/// `eye`. They cover about as much of the picture whatever their number.
std::vector<CsgSphere> visible_spheres(int count, const glm::dvec3& eye);

/// The text `function(part, part, ...)`, or the part alone where there is only one.
std::string combined(const std::string& function, const std::vector<CsgSphere>& parts);

}  // namespace zeroset::test
