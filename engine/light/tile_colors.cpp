#include "engine/light/tile_colors.hpp"

#include "engine/image/gamma.hpp"
#include "engine/light/surface_values.hpp"
#include "engine/view/pixel_ray.hpp"

#include <cmath>
#include <vector>

namespace zeroset {
namespace {

/// The hits of a tile, row by row.
struct Hits {
    std::vector<std::size_t> pixels;
    std::vector<SurfacePoint> points;
};

Hits hits_of(const TraceFrame& frame, const Tile& tile, const TileHits& hits) {
    Hits found;
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const auto pixel = static_cast<std::size_t>(row * tile_size + col);
            const auto distance = static_cast<double>(hits.depth[pixel]);
            if (!std::isfinite(distance)) continue;
            const PixelRay ray = pixel_ray(frame.view, tile.place(col, row), frame.image);
            found.pixels.push_back(pixel);
            found.points.push_back({ray.at(distance), distance});
        }
    }
    return found;
}

void set(LitLayer& layer, std::size_t pixel, const Reflectance& color) {
    for (std::size_t channel = 0; channel < 3; ++channel)
        layer.reflectance[channel][pixel] = color[channel];
}

Reflectance plain_front(const Scene& scene, std::size_t surface) {
    const SurfaceColors& colors =
        surface < scene.colors.size() ? scene.colors[surface] : colors_of(surface);
    return {colors.front[0], colors.front[1], colors.front[2]};
}

/// (n + 1) / 2 as it shows in full light, for the direction n of the gradient.
Reflectance normal_color(const TileHits& hits, std::size_t pixel) {
    const glm::dvec3 gradient(hits.gradient[0][pixel], hits.gradient[1][pixel],
                              hits.gradient[2][pixel]);
    const double length = glm::length(gradient);
    if (!(length > 0.0) || !std::isfinite(length)) return color_at(ColorMap::Gray, std::nan(""));
    const glm::dvec3 shown = 0.5 * (gradient / length + 1.0);
    const glm::dvec3 linear = gamma_decoded(shown);
    return {static_cast<float>(linear.x), static_cast<float>(linear.y),
            static_cast<float>(linear.z)};
}

}  // namespace

void find_colors(const TraceFrame& frame, const Tile& tile, LitLayer& layer, Counters& counters) {
    const TileHits& hits = *layer.hits;
    const Coloring& coloring = frame.scene.coloring;
    const bool plain = coloring.by == ColorBy::Plain;
    const std::size_t size = plain ? 0 : hits.depth.size();
    for (std::vector<float>& channel : layer.reflectance)
        channel.resize(size);
    if (size == 0) return;
    const Hits found = hits_of(frame, tile, hits);
    if (!has_range(coloring.by)) {
        for (const std::size_t pixel : found.pixels)
            set(layer, pixel, normal_color(hits, pixel));
        return;
    }
    if (has_formula(coloring.by)) counters.value += found.pixels.size();
    const std::vector<double> values = values_at(frame.scene, layer.surface, found.points);
    const ValueRange range = coloring.range.value_or(ValueRange());
    const bool plain_caps = hits.any_cap && is_of_skin(coloring.by);
    const Reflectance plain_color = plain_front(frame.scene, layer.surface);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool is_plain = plain_caps && hits.cap[found.pixels[i]] != 0;
        set(layer, found.pixels[i],
            is_plain ? plain_color : color_at(coloring.map, range.place(values[i])));
    }
}

}  // namespace zeroset
