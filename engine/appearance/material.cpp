#include "engine/appearance/material.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {

Material material_of(Look look) {
    switch (look) {
        case Look::Standard:
        case Look::Phong: return {.roughness = 0.1F, .reflectance = 0.05F};
        case Look::Matte: return {};
        case Look::Porcelain:
            return {.roughness = 0.16F,
                    .reflectance = 0.05F,
                    .stain = {0.93F, 0.92F, 0.88F},
                    .stain_share = 0.35F};
        case Look::Metal:
            return {.metalness = 1.0F,
                    .roughness = 0.24F,
                    .stain = {0.95F, 0.93F, 0.90F},
                    .stain_share = 0.40F};
        case Look::Glass:
            return {.roughness = 0.05F,
                    .reflectance = 0.06F,
                    .opacity = 0.18F,
                    .stain = {0.9F, 0.95F, 0.95F},
                    .stain_share = 0.15F};
        case Look::Clay: return {.stain = {0.62F, 0.50F, 0.42F}, .stain_share = 0.62F};
        case Look::Technical:
            return {.stain = {0.94F, 0.94F, 0.92F}, .stain_share = 0.78F, .surroundings = 1.0F};
    }
    return {};
}

glm::vec3 mirrored_share(const glm::vec3& head_on, float roughness, float cosine) {
    const glm::vec4 r = roughness * glm::vec4(-1.0F, -0.0275F, -0.572F, 0.022F) +
                        glm::vec4(1.0F, 0.0425F, 1.04F, -0.04F);
    const float slope = std::min(r.x * r.x, std::exp2(-9.28F * cosine)) * r.x + r.y;
    const float scale = -1.04F * slope + r.z;
    const float bias = 1.04F * slope + r.w;
    return glm::clamp(head_on * scale + bias, 0.0F, 1.0F);
}

glm::vec3 fresnel(const glm::vec3& head_on, float half_cosine) {
    const float aside = 1.0F - std::clamp(half_cosine, 0.0F, 1.0F);
    const float power = aside * aside * aside * aside * aside;
    return head_on + (1.0F - head_on) * power;
}

}  // namespace zeroset
