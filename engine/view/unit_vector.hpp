#pragma once

#include <glm/glm.hpp>

namespace zeroset {

/// A direction: a vector of length 1.
struct UnitVector : glm::dvec3 {
    /// Along `vector`, which is not 0.
    explicit UnitVector(const glm::dvec3& vector) : glm::dvec3(glm::normalize(vector)) {}
};

}  // namespace zeroset
