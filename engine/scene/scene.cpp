#include "engine/scene/scene.hpp"

#include <algorithm>

namespace zeroset {

bool have_same_code(const std::vector<Surface>& a, const std::vector<Surface>& b) {
    const auto same = [](const Surface& x, const Surface& y) {
        return x.kernel.in_float.range == y.kernel.in_float.range;
    };
    return std::ranges::equal(a, b, same);
}

Look look_of(const Scene& scene, std::size_t surface) {
    return scene.surfaces[surface].look.look.value_or(scene.lighting.look);
}

bool has_soft_light(const Scene& scene) {
    const auto darkens = [](const Surface& surface) {
        return surface.look.look && ambient_shade(*surface.look.look) > 0.0F;
    };
    return ambient_shade(scene.lighting.look) > 0.0F || has_broad_light(scene.lighting) ||
           std::ranges::any_of(scene.surfaces, darkens);
}

bool has_soft_light(const Scene& scene, std::size_t surface) {
    return ambient_shade(look_of(scene, surface)) > 0.0F || has_broad_light(scene.lighting);
}

}  // namespace zeroset
