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

/// The light that comes from all around, where nothing of the scene is in its way: a bright sky
/// over a darker floor, and a broad lamp where the key light is. It goes with the camera, as lights
/// do.
class Surroundings {
public:
    Surroundings(const ViewFrame& view, const glm::vec3& towards_lamp);

    /// Linear light from a direction of length 1, as a mirror of this roughness shows it.
    [[nodiscard]] glm::vec3 seen(const glm::vec3& direction, float roughness) const;
    /// The light on a matte surface, per light that it reflects; of the sky and the floor.
    [[nodiscard]] glm::vec3 on(const glm::vec3& normal) const;

private:
    glm::vec3 up_, towards_lamp_;
};

}  // namespace zeroset
