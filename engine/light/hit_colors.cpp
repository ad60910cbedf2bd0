#include "engine/image/gamma.hpp"
#include "engine/light/surface_values.hpp"

#include <cmath>

namespace zeroset {
namespace {

Reflectance plain_color(const Scene& scene, std::size_t surface, bool is_front) {
    const SurfaceColors& colors = scene.colors_of_surface(surface);
    const float(&side)[3] = is_front ? colors.front : colors.back;
    return {side[0], side[1], side[2]};
}

/// (n + 1) / 2 as it shows in full light, for the direction n of the gradient.
Reflectance normal_color(const glm::dvec3& gradient) {
    const double length = glm::length(gradient);
    if (!(length > 0.0) || !std::isfinite(length)) return color_at(ColorMap::Gray, std::nan(""));
    const glm::dvec3 linear = gamma_decoded(0.5 * (gradient / length + 1.0));
    return {static_cast<float>(linear.x), static_cast<float>(linear.y),
            static_cast<float>(linear.z)};
}

}  // namespace

std::vector<Reflectance> hit_colors(const Scene& scene, std::size_t surface,
                                    std::span<const ColoredHit> hits) {
    const Coloring& coloring = scene.coloring;
    std::vector<Reflectance> colors;
    colors.reserve(hits.size());
    if (!has_range(coloring.by)) {
        for (const ColoredHit& hit : hits)
            colors.push_back(coloring.by == ColorBy::Plain
                                 ? plain_color(scene, surface, hit.is_front)
                                 : normal_color(hit.gradient));
        return colors;
    }
    std::vector<SurfacePoint> points;
    points.reserve(hits.size());
    for (const ColoredHit& hit : hits)
        points.push_back(hit.point);
    const std::vector<double> values = values_at(scene, surface, points);
    const ValueRange range = coloring.range.value_or(ValueRange());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool is_plain = hits[i].is_cap && is_of_skin(coloring.by);
        colors.push_back(is_plain ? plain_color(scene, surface, true)
                                  : color_at(coloring.map, range.place(values[i])));
    }
    return colors;
}

}  // namespace zeroset
