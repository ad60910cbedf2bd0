#include "engine/light/lit_tile.hpp"

#include "engine/light/surface_values.hpp"
#include "engine/light/tile_light.hpp"
#include "engine/trace/hit_gradients.hpp"

#include <vector>

namespace zeroset {

LitLayer::LitLayer() {
    constexpr std::size_t pixels = static_cast<std::size_t>(tile_size) * tile_size;
    light.resize(3 * pixels);
}

void LitTile::begin(std::span<const TileHits> hits) {
    count_ = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i].any) continue;
        if (count_ == kept_.size()) kept_.emplace_back();
        LitLayer& layer = kept_[count_++];
        layer.surface = static_cast<std::uint8_t>(i);
        layer.hits = &hits[i];
        layer.dark_rows = {};
        layer.cover.clear();
        for (std::vector<float>& channel : layer.reflectance)
            channel.clear();
    }
}

void find_colors(const TraceFrame& frame, const Tile& tile, LitLayer& layer, Counters& counters) {
    const TileHits& hits = *layer.hits;
    const Coloring& coloring = frame.scene.coloring;
    const bool plain = coloring.by == ColorBy::Plain;
    const std::size_t size = plain ? 0 : hits.depth.size();
    for (std::vector<float>& channel : layer.reflectance)
        channel.resize(size);
    if (size == 0) return;
    std::vector<std::size_t> pixels;
    std::vector<ColoredHit> colored;
    for_each_hit(frame, tile, hits, [&](std::size_t pixel, const PixelRay& ray, double distance) {
        pixels.push_back(pixel);
        colored.push_back({.point = {.at = ray.at(distance), .distance = distance},
                           .gradient = hits.gradient_at(pixel),
                           .is_cap = hits.is_cap(pixel),
                           .is_front = true});
    });
    if (has_formula(coloring.by)) counters.value += pixels.size();
    const std::vector<Reflectance> colors = hit_colors(frame.scene, layer.surface, colored);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            layer.reflectance[channel][pixels[i]] = colors[i][channel];
    }
}

}  // namespace zeroset
