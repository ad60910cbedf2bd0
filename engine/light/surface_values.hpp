#pragma once

#include "engine/scene/scene.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// A point of a surface, world units.
struct SurfacePoint {
    glm::dvec3 at;
    double distance;  ///< from the eye along its ray
};

/// The numbers behind the scene's colours at points of one of its surfaces; NaN where there is
/// none. In upward rounding; the scene's coloring has a range (has_range).
std::vector<double> values_at(const Scene& scene, std::size_t surface,
                              std::span<const SurfacePoint> points);

}  // namespace zeroset
