#pragma once

#include <glm/glm.hpp>

namespace zeroset {

/// Eigenvectors of a symmetric matrix, of length 1 and at right angles, as columns; the eigenvalues
/// fall.
struct Eigenvectors {
    glm::dmat3 vectors;
    glm::dvec3 values;
};
Eigenvectors eigenvectors_of(const glm::dmat3& symmetric);

}  // namespace zeroset
