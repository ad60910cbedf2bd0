#include "engine/light/surface_values.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

std::vector<double> formula_at(const PointFunction& formula, const Uniforms& uniforms,
                               std::span<const SurfacePoint> points) {
    const std::size_t size = (points.size() + batch_multiple - 1) / batch_multiple * batch_multiple;
    std::array<std::vector<double>, 3> x;
    for (int k = 0; k < 3; ++k) {
        std::vector<double>& column = x.at(static_cast<std::size_t>(k));
        column.resize(size);
        for (std::size_t i = 0; i < size; ++i)
            column[i] = points[std::min(i, points.size() - 1)].at[k];
    }
    std::vector<double> values(size);
    formula(ValueBatchOf<double>{size,
                                 {x[0].data(), x[1].data(), x[2].data()},
                                 uniforms.points<double>(),
                                 values.data(),
                                 {}});
    values.resize(points.size());
    return values;
}

}  // namespace

std::vector<double> values_at(const Scene& scene, std::size_t surface,
                              std::span<const SurfacePoint> points) {
    if (points.empty()) return {};
    const Coloring& coloring = scene.coloring;
    if (has_formula(coloring.by)) {
        return formula_at(coloring.values[surface], scene.uniforms, points);
    }
    std::vector<double> values;
    for (const SurfacePoint& point : points)
        values.push_back(coloring.by == ColorBy::Depth ? point.distance
                                                       : glm::dot(coloring.up, point.at));
    return values;
}

}  // namespace zeroset
