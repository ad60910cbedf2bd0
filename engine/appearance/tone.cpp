#include "engine/appearance/tone.hpp"

namespace zeroset {

glm::vec3 toned(Tone tone, const glm::vec3& light) {
    if (tone == Tone::Plain) return light;
    constexpr float exposure = 0.7232F;  // toned(0.18) = 0.18
    const glm::vec3 x = exposure * light;
    return glm::clamp(x * (2.51F * x + 0.03F) / (x * (2.43F * x + 0.59F) + 0.14F), 0.0F, 1.0F);
}

}  // namespace zeroset
