#include "engine/image/gamma.hpp"
#include "engine/light/surface_values.hpp"
#include "engine/real/rounding.hpp"
#include "pipeline/mesh_solid.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

MeshColor shown(const Reflectance& light) {
    MeshColor color;
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<std::uint8_t>(channel_of_light(light[i]));
    return color;
}

/// The range that holds all values but the few least and greatest.
ValueRange range_of(std::vector<double> values, bool is_signed) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return {};
    std::ranges::sort(values);
    const std::size_t aside = values.size() / 50;
    ValueRange range{.lo = values[aside], .hi = values[values.size() - 1 - aside]};
    if (is_signed) {
        const double most = std::max(std::abs(range.lo), std::abs(range.hi));
        range = {.lo = -most, .hi = most};
    }
    if (!(range.lo < range.hi)) range.hi = range.lo + std::max(1e-9, 1e-9 * std::abs(range.lo));
    return range;
}

}  // namespace

void color_object(const Scene& scene, std::size_t surface, const glm::dvec3& eye,
                  MeshObject& object) {
    const SurfaceColors& plain = scene.colors_of_surface(surface);
    object.color = shown({plain.front[0], plain.front[1], plain.front[2]});
    if (scene.coloring.by == ColorBy::Plain) return;
    const UpwardRegisters upward;
    std::vector<ColoredHit> hits;
    std::vector<SurfacePoint> points;
    for (const MeshVertex& vertex : object.mesh.vertices) {
        points.push_back({.at = vertex.point, .distance = glm::distance(vertex.point, eye)});
        hits.push_back({.point = points.back(),
                        .gradient = vertex.normal,
                        .is_cap = vertex.part > 0,
                        .is_front = true});
    }
    Scene colored = scene;
    Coloring& coloring = colored.coloring;
    if (has_range(coloring.by) && !coloring.range) {
        coloring.range = ValueRange();
        coloring.range = range_of(values_at(colored, surface, points), is_signed(coloring.by));
    }
    for (const Reflectance& light : hit_colors(colored, surface, hits))
        object.colors.push_back(shown(light));
}

}  // namespace zeroset
