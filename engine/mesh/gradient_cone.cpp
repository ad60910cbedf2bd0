#include "engine/mesh/gradient_cone.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

glm::dvec3 direction_of(const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return length > 0 && std::isfinite(length) ? vector / length : glm::dvec3(0.0);
}

}  // namespace

double least_slope(const GradientBox& gradient, const glm::dvec3& direction) {
    double negative = 0.0;  // an upper bound of -slope
    for (int axis = 0; axis < 3; ++axis)
        negative +=
            std::max(-direction[axis] * gradient.lo[axis], -direction[axis] * gradient.hi[axis]);
    return -negative;
}

std::optional<glm::dvec3> common_rise(std::span<const GradientBox> gradients) {
    constexpr int most_turns = 24;
    glm::dvec3 sum(0.0);
    for (const GradientBox& gradient : gradients)
        sum += direction_of(gradient.middle());
    // The perceptron's rule: a gradient that does not rise pulls the direction towards itself.
    for (int turn = 0; turn < most_turns; ++turn) {
        const glm::dvec3 direction = direction_of(sum);
        const GradientBox* worst = nullptr;
        double least = 0.0;
        for (const GradientBox& gradient : gradients) {
            const double slope = least_slope(gradient, direction);
            const double size = glm::length(gradient.middle());
            if (slope > 0 || !(slope <= least * size)) continue;
            least = size > 0 ? slope / size : -1e300;
            worst = &gradient;
        }
        if (worst == nullptr) {
            const bool rises = std::ranges::all_of(gradients, [&](const GradientBox& gradient) {
                return least_slope(gradient, direction) > 0;
            });
            if (!rises) return std::nullopt;
            return direction;
        }
        // The corner of the box that rises least.
        glm::dvec3 corner;
        for (int axis = 0; axis < 3; ++axis)
            corner[axis] = direction[axis] > 0 ? worst->lo[axis] : worst->hi[axis];
        if (corner == glm::dvec3(0.0)) return std::nullopt;
        sum += direction_of(corner);
    }
    return std::nullopt;
}

}  // namespace zeroset
