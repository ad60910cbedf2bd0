#include "pipeline/section_values.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/color_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// Points spread evenly over the box: an additive lattice.
PointBatch<double> spread_points(const Box& box) {
    constexpr std::size_t count = 4096;
    // 1 / g, 1 / g^2 and 1 / g^3 for the root g of g^4 = g + 1
    const glm::dvec3 steps(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    PointBatch<double> points(count, PointBatch<double>::Asks::Value);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 share = glm::fract(0.5 + static_cast<double>(i) * steps);
        const glm::dvec3 at = glm::mix(box.lo, box.hi, share);
        points.set(i, at.x, at.y, at.z);
    }
    points.pad();
    return points;
}

ValueRange usual_range(const Scene& scene, ColorMap map) {
    PointBatch<double> points = spread_points(scene.clip);
    const UpwardRounding upward;
    std::vector<double> all;
    for (const Surface& surface : scene.surfaces) {
        if (!surface.section_value) continue;
        surface.section_value(points.batch(scene.uniforms.points<double>()));
        for (std::size_t i = 0; i < points.count(); ++i)
            all.push_back(points.f(i));
    }
    return fitting_range(std::move(all), map == ColorMap::Balance);
}

}  // namespace

std::optional<SectionValues> section_values(const SectionChoice& choice, const Scene& scene) {
    if (std::ranges::none_of(scene.region.sections, &Section::values)) return std::nullopt;
    SectionValues shown{.map = choice.map.value_or(ColorMap::Gray)};
    shown.usual_range = usual_range(scene, shown.map);
    shown.range = choice.range.value_or(shown.usual_range);
    return shown;
}

}  // namespace zeroset
