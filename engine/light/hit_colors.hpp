#pragma once

#include "engine/image/color_map.hpp"
#include "engine/light/surface_values.hpp"
#include "engine/scene/scene.hpp"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

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
