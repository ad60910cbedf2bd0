#include "engine/light/surface_values.hpp"

#include "engine/kernel/point_batch.hpp"

namespace zeroset {
namespace {

std::vector<double> formula_at(const PointFunction& formula, const Uniforms& uniforms,
                               std::span<const SurfacePoint> points) {
    PointBatch<double> batch(points.size(), PointBatch<double>::Asks::Value);
    for (std::size_t i = 0; i < points.size(); ++i)
        batch.set(i, points[i].at.x, points[i].at.y, points[i].at.z);
    batch.pad();
    formula(batch.batch(uniforms.points<double>()));
    std::vector<double> values;
    values.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        values.push_back(batch.f(i));
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
