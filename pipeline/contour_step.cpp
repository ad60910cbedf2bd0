#include "pipeline/contour_step.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/color_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace zeroset {
namespace {

constexpr std::size_t side = 14;  ///< points of the grid along an edge of the box
constexpr double least_lines = 7.0;

glm::dvec3 grid_point(const Box& box, std::size_t i) {
    const glm::dvec3 part(static_cast<double>(i % side), static_cast<double>(i / side % side),
                          static_cast<double>(i / side / side));
    return box.lo + (box.hi - box.lo) * part / static_cast<double>(side - 1);
}

std::vector<double> values_of(const PointFunction& function, const Uniforms& uniforms,
                              const std::vector<glm::dvec3>& points) {
    if (points.empty()) return {};
    const UpwardRounding upward;
    PointBatch<double> batch(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        batch.set(i, points[i].x, points[i].y, points[i].z);
    batch.pad();
    batch.evaluate(function, uniforms.points<double>(), [] { return false; });
    std::vector<double> values;
    values.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        values.push_back(batch.f(i));
    return values;
}

/// Adds about where f is 0 on edges of the grid, whose points are `grid`, at which it is `f`.
void add_crossings(const std::vector<glm::dvec3>& grid, const std::vector<double>& f,
                   std::vector<glm::dvec3>& crossings) {
    for (std::size_t i = 0; i < grid.size(); ++i) {
        for (const std::size_t stride : {std::size_t{1}, side, side * side}) {
            if (i / stride % side + 1 == side) continue;
            const double a = f[i];
            const double b = f[i + stride];
            if (!(a * b <= 0.0) || a == b) continue;
            crossings.push_back(glm::mix(grid[i], grid[i + stride], a / (a - b)));
        }
    }
}

}  // namespace

double even_step(double length) {
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    for (const double digit : {5.0, 2.0}) {
        if (digit * power <= length) return digit * power;
    }
    return power;
}

double contour_step(const Scene& scene, const PointFunction& number) {
    std::vector<glm::dvec3> grid;
    grid.reserve(side * side * side);
    for (std::size_t i = 0; i < side * side * side; ++i)
        grid.push_back(grid_point(scene.clip, i));
    std::vector<glm::dvec3> crossings;
    for (const Surface& surface : scene.surfaces)
        add_crossings(grid, values_of(surface.kernel.in_double.value, scene.uniforms, grid),
                      crossings);
    std::vector<double> values =
        values_of(number, scene.uniforms, crossings.empty() ? grid : crossings);
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return 1.0;
    const ValueRange range = fitting_range(std::move(values), false);
    return even_step((range.hi - range.lo) / least_lines);
}

}  // namespace zeroset
