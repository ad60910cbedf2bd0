#include "engine/appearance/lights.hpp"

#include "engine/light/shade.hpp"

#include <glm/gtc/constants.hpp>

namespace zeroset {
namespace {

SeenLight seen(const Light& light, const ViewFrame& view) {
    const glm::dvec3 towards = light.with_camera ? view.from_view(light.towards) : light.towards;
    return {.towards = glm::normalize(towards),
            .color = static_cast<float>(light.power) *
                     glm::vec3(light.color[0], light.color[1], light.color[2]),
            .radius_rad = light.radius_deg * glm::pi<double>() / 180.0,
            .casts_shadows = true};
}

}  // namespace

std::vector<SeenLight> lights_of(const Lighting& lighting, const ViewFrame& view) {
    std::vector<SeenLight> lights;
    lights.reserve(max_lights);
    for (const Light& light : lighting.lights)
        lights.push_back(seen(light, view));
    if (!lights.empty()) return lights;
    lights.push_back({.towards = key_light(view),
                      .color = glm::vec3(0.85F),
                      .radius_rad = 0.0,
                      .casts_shadows = true});
    if (lighting.look == Look::Phong) return lights;
    lights.push_back({.towards = fill_light(view),
                      .color = glm::vec3(0.26F),
                      .radius_rad = 0.0,
                      .casts_shadows = false});
    return lights;
}

}  // namespace zeroset
