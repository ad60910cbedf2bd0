#include "engine/scene/lighting.hpp"

#include "engine/base/enum_names.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr auto look_names = enum_names<Look>("standard", "phong", "matte", "porcelain", "metal",
                                             "glass", "clay", "technical");
constexpr auto tone_names = enum_names<Tone>("plain", "filmic");

bool has_broad_light(const Lighting& lighting) {
    return std::ranges::any_of(lighting.lights,
                               [](const Light& light) { return light.radius_deg > 0.0; });
}

}  // namespace

std::span<const Look> looks() { return look_names.values(); }

std::string_view name_of(Look look) { return look_names.of(look); }

std::optional<Look> look_named(std::string_view name) { return look_names.named(name); }

std::string_view name_of(Tone tone) { return tone_names.of(tone); }

std::optional<Tone> tone_named(std::string_view name) { return tone_names.named(name); }

float ambient_shade(Look look) {
    switch (look) {
        case Look::Standard:
        case Look::Phong:
        case Look::Matte:
        case Look::Glass:
        case Look::Technical: return 0.0F;
        case Look::Porcelain: return 0.6F;
        case Look::Metal: return 0.5F;
        case Look::Clay: return 1.0F;
    }
    return 0.0F;
}

Look look_of(const Lighting& lighting, std::size_t surface) {
    if (surface >= lighting.surfaces.size()) return lighting.look;
    return lighting.surfaces[surface].look.value_or(lighting.look);
}

bool has_soft_light(const Lighting& lighting) {
    const auto darkens = [](const SurfaceLook& surface) {
        return surface.look && ambient_shade(*surface.look) > 0.0F;
    };
    return ambient_shade(lighting.look) > 0.0F || has_broad_light(lighting) ||
           std::ranges::any_of(lighting.surfaces, darkens);
}

bool has_soft_light(const Lighting& lighting, std::size_t surface) {
    return ambient_shade(look_of(lighting, surface)) > 0.0F || has_broad_light(lighting);
}

}  // namespace zeroset
