#include "engine/mesh/field_at_points.hpp"

#include "engine/mesh/parallel.hpp"

#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// Points of a stretch, in order.
void evaluate_part(const MeshSolid& solid, std::size_t number, std::span<const glm::dvec3> points,
                   PointBatch<double>& batch, std::span<FieldValue> values) {
    const SolidPart& part = solid.parts[number];
    part.value(batch.batch(solid.uniforms.points<double>()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        double f = part.sign * batch.f(i);
        if (std::isnan(f)) f = std::numeric_limits<double>::infinity();
        if (number > 0 && f <= values[i].f) continue;
        values[i].f = f;
        values[i].part = static_cast<std::uint32_t>(number);
        values[i].gradient = part.sign * glm::dvec3(batch.gradient(0, i), batch.gradient(1, i),
                                                    batch.gradient(2, i));
    }
}

void evaluate_cuts(const MeshSolid& solid, std::span<const glm::dvec3> points,
                   std::span<FieldValue> values) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t c = 0; c < solid.cuts.size(); ++c) {
            const double f = solid.cuts[c].value(points[i]);
            if (f <= values[i].f) continue;
            values[i] = {.f = f,
                         .gradient = solid.cuts[c].gradient(points[i]),
                         .part = static_cast<std::uint32_t>(solid.parts.size() + c)};
        }
    }
}

}  // namespace

double FieldValue::distance() const {
    const double slope = glm::length(gradient);
    if (f == 0.0) return 0.0;
    return slope > 0 ? std::abs(f) / slope : std::numeric_limits<double>::infinity();
}

std::vector<FieldValue> field_at(const MeshSolid& solid, std::span<const glm::dvec3> points,
                                 int threads) {
    constexpr std::size_t stretch = 512;
    std::vector<FieldValue> values(points.size());
    parallel_upward(points.size(), stretch, threads, [&](std::size_t first, std::size_t last) {
        static thread_local PointBatch<double> batch;
        const auto some = points.subspan(first, last - first);
        const auto out = std::span(values).subspan(first, last - first);
        batch.resize(some.size());
        for (std::size_t i = 0; i < some.size(); ++i)
            batch.set(i, some[i].x, some[i].y, some[i].z);
        batch.pad();
        for (std::size_t p = 0; p < solid.parts.size(); ++p)
            evaluate_part(solid, p, some, batch, out);
        evaluate_cuts(solid, some, out);
    });
    return values;
}

}  // namespace zeroset
