#include "engine/draw/symmetric.hpp"

#include <cmath>
#include <utility>

namespace zeroset {
namespace {

/// Turns the matrix in the plane of two axes so that its member there becomes 0.
void rotate(glm::dmat3& matrix, glm::dmat3& vectors, int p, int q) {
    if (matrix[p][q] == 0.0) return;
    const double angle = 0.5 * std::atan2(2.0 * matrix[p][q], matrix[q][q] - matrix[p][p]);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    glm::dmat3 turn(1.0);
    turn[p][p] = turn[q][q] = c;
    turn[q][p] = s;
    turn[p][q] = -s;
    matrix = glm::transpose(turn) * matrix * turn;
    vectors = vectors * turn;
}

}  // namespace

Eigenvectors eigenvectors_of(const glm::dmat3& symmetric) {
    constexpr int sweeps = 12;
    glm::dmat3 matrix = symmetric;
    Eigenvectors all{.vectors = glm::dmat3(1.0), .values = {}};
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        rotate(matrix, all.vectors, 0, 1);
        rotate(matrix, all.vectors, 0, 2);
        rotate(matrix, all.vectors, 1, 2);
    }
    for (int i = 0; i < 3; ++i)
        all.values[i] = matrix[i][i];
    for (const auto& [i, k] : {std::pair{0, 1}, {1, 2}, {0, 1}}) {
        if (all.values[i] >= all.values[k]) continue;
        std::swap(all.values[i], all.values[k]);
        std::swap(all.vectors[i], all.vectors[k]);
    }
    return all;
}

}  // namespace zeroset
