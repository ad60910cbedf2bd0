#pragma once

#include "engine/scene/lighting.hpp"
#include "engine/view/camera.hpp"

#include <glm/glm.hpp>

#include <vector>

namespace zeroset {

/// A light as a picture's surfaces see it.
struct SeenLight {
    glm::dvec3 towards;  ///< of length 1, world axes
    glm::vec3 color;     ///< linear, times its power
    double radius_rad;
    bool casts_shadows;
};

/// The lights of a scene in a view: its own, or those of its look: a key light, which casts
/// shadows, and, but for Phong's, a fill light, which casts none.
std::vector<SeenLight> lights_of(const Lighting& lighting, const ViewFrame& view);

}  // namespace zeroset
