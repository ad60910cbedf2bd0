#pragma once

#include "engine/image/color_map.hpp"
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

/// A hit of a surface whose colour is asked for.
struct ColoredHit {
    SurfacePoint point;
    glm::dvec3 gradient;  ///< of f, of whatever size
    bool is_cap;
    bool is_front;  ///< seen from where f > 0
};

/// The reflectances of hits of one surface, by the scene's coloring. In upward rounding.
std::vector<Reflectance> hit_colors(const Scene& scene, std::size_t surface,
                                    std::span<const ColoredHit> hits);

}  // namespace zeroset
