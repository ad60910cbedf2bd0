#include "engine/appearance/frame_light.hpp"

#include "engine/appearance/light_paths.hpp"
#include "engine/light/shade.hpp"
#include "engine/light/shadow.hpp"
#include "engine/light/tile_light.hpp"
#include "engine/trace/caps.hpp"

#include <algorithm>

namespace zeroset {
namespace {

/// Whether the quick way of the standard look does not do.
bool needs_rays(const Scene& scene, const TraceSettings& settings) {
    const Lighting& lighting = scene.lighting;
    const auto is_special = [](const Surface& surface) {
        return surface.look.opacity.value_or(1.0) < 1.0 ||
               surface.look.look.value_or(Look::Standard) != Look::Standard;
    };
    return lighting.look != Look::Standard || !lighting.lights.empty() ||
           lighting.tone != Tone::Plain || settings.reflections > 0 ||
           std::ranges::any_of(scene.surfaces, is_special);
}

}  // namespace

FrameLight::FrameLight(const Scene& scene, const ViewFrame& view, const TraceSettings& settings,
                       int fineness)
    : scene_(scene),
      settings_(settings),
      fineness_(fineness),
      shader_(scene.lighting, view, settings.reflections > 0),
      by_rays_(needs_rays(scene, settings)) {
    if (!by_rays_ || !(scene.lighting.absorption > 0.0)) return;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
        solid_signs_.push_back(solid_sign(scene, i));
}

float FrameLight::opacity(std::size_t surface) const {
    const auto& chosen = scene_.surfaces[surface].look.opacity;
    return chosen ? static_cast<float>(*chosen) : material_of(look(surface)).opacity;
}

void FrameLight::light(std::span<const TraceFrame> surfaces, const TimeLimit& limit,
                       const Tile& tile, std::span<const TileHits> hits, LitTile& out,
                       Counters& counters, const KnownShadows& known) const {
    out.begin(hits);
    light_hits(surfaces, limit, tile, out, counters, known);
    for (LitLayer& layer : out.layers())
        show_section_values(surfaces[layer.surface], tile, fineness_, layer, counters);
    if (!out.layers().empty()) draw_lines(surfaces, fineness_, tile, out.layers(), counters);
}

void FrameLight::light_hits(std::span<const TraceFrame> surfaces, const TimeLimit& limit,
                            const Tile& tile, LitTile& out, Counters& counters,
                            const KnownShadows& known) const {
    if (by_rays_) return light_paths(*this, surfaces, limit, tile, out.layers(), counters);
    if (settings_.shadows && !out.layers().empty()) {
        const UnitVector to_light = key_light(surfaces.front().view);
        const ShadowBits found =
            find_shadows(surfaces, to_light, limit, tile, out.layers(), counters, known.known);
        TileBits dark = found.dark;
        for (std::size_t row = 0; row < tile_size; ++row)
            dark[row] |= known.dark[row];
        darken(dark, out.layers());
    }
    for (LitLayer& layer : out.layers()) {
        find_colors(surfaces[layer.surface], tile, layer, counters);
        shade(surfaces[layer.surface], tile, layer);
    }
}

}  // namespace zeroset
