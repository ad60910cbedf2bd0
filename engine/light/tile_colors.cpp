#include "engine/light/tile_colors.hpp"

#include "engine/light/hit_colors.hpp"
#include "engine/view/pixel_ray.hpp"

#include <cmath>
#include <vector>

namespace zeroset {

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
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const auto pixel = static_cast<std::size_t>(row * tile_size + col);
            const auto distance = static_cast<double>(hits.depth[pixel]);
            if (!std::isfinite(distance)) continue;
            const PixelRay ray = pixel_ray(frame.view, tile.place(col, row), frame.image);
            pixels.push_back(pixel);
            colored.push_back({.point = {.at = ray.at(distance), .distance = distance},
                               .gradient = {hits.gradient[0][pixel], hits.gradient[1][pixel],
                                            hits.gradient[2][pixel]},
                               .is_cap = hits.any_cap && hits.cap[pixel] != 0,
                               .is_front = true});
        }
    }
    if (has_formula(coloring.by)) counters.value += pixels.size();
    const std::vector<Reflectance> colors = hit_colors(frame.scene, layer.surface, colored);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            layer.reflectance[channel][pixels[i]] = colors[i][channel];
    }
}

}  // namespace zeroset
