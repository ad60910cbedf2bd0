#include "engine/scene/lighting.hpp"

#include "engine/base/enum_names.hpp"

#include <algorithm>

namespace zeroset {
namespace {

constexpr auto look_names = enum_names<Look>("standard", "phong", "matte", "porcelain", "metal",
                                             "glass", "clay", "technical");
constexpr auto tone_names = enum_names<Tone>("plain", "filmic");

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

bool has_broad_light(const Lighting& lighting) {
    return std::ranges::any_of(lighting.lights,
                               [](const Light& light) { return light.radius_deg > 0.0; });
}

}  // namespace zeroset
