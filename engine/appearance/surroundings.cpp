#include "engine/appearance/lights.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

constexpr glm::vec3 zenith(0.62F, 0.70F, 0.82F);
constexpr glm::vec3 horizon(0.86F, 0.86F, 0.84F);
constexpr glm::vec3 floor_near(0.26F, 0.25F, 0.24F);
constexpr glm::vec3 floor_below(0.12F, 0.11F, 0.11F);
constexpr float lamp_light = 2.6F;
constexpr float lamp_cosine = 0.93F;  ///< of the angle from the lamp's middle to its rim

}  // namespace

Surroundings::Surroundings(const ViewFrame& view, const glm::vec3& towards_lamp)
    : up_(view.up), towards_lamp_(towards_lamp) {}

glm::vec3 Surroundings::seen(const glm::vec3& direction, float roughness) const {
    const float height = glm::dot(direction, up_);
    const float blur = 0.03F + 0.6F * roughness;
    const glm::vec3 sky = glm::mix(horizon, zenith, std::clamp(height, 0.0F, 1.0F));
    const glm::vec3 ground = glm::mix(floor_near, floor_below, std::clamp(-height, 0.0F, 1.0F));
    const glm::vec3 around = glm::mix(ground, sky, glm::smoothstep(-blur, blur, height));
    const float to_lamp = glm::dot(direction, towards_lamp_);
    const float rim = 0.02F + 0.3F * roughness;
    const float lamp = glm::smoothstep(lamp_cosine - rim, lamp_cosine + 0.3F * rim, to_lamp);
    return around + lamp_light / (1.0F + 4.0F * roughness) * lamp;
}

glm::vec3 Surroundings::on(const glm::vec3& normal) const {
    const float share = 0.5F + 0.5F * glm::dot(normal, up_);
    return glm::mix(0.5F * (floor_near + floor_below), 0.5F * (horizon + zenith), share);
}

}  // namespace zeroset
