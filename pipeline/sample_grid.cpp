#include "pipeline/sample_grid.hpp"

#include "engine/base/parallel.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/kernel/point_batch.hpp"
#include "engine/real/rounding.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace zeroset {

Geometry geometry_of(const GridPlan& plan) {
    Geometry geometry;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        geometry.origin[i] = plan.box.lo[axis];
        geometry.world_from_index[i] = {};
        geometry.world_from_index[i][i] =
            (plan.box.hi[axis] - plan.box.lo[axis]) / static_cast<double>(plan.size[i] - 1);
    }
    return geometry;
}

Samples sampled(const Expr& f, const Uniforms& uniforms, const GridPlan& plan) {
    const Geometry geometry = geometry_of(plan);
    const PointFunction function = interpret_points(f);
    const std::size_t width = plan.size[0];
    const auto numbers =
        std::make_shared<std::vector<float>>(plan.size[0] * plan.size[1] * plan.size[2]);
    const auto coordinate = [&](std::size_t axis, std::uint64_t index) {
        return geometry.origin[axis] +
               geometry.world_from_index[axis][axis] * static_cast<double>(index);
    };
    parallel_for(plan.size[1] * plan.size[2], 0, [&](std::size_t row) {
        const UpwardRounding upward;
        PointBatch<double> batch(width, PointBatch<double>::Asks::Value);
        const double y = coordinate(1, row % plan.size[1]);
        const double z = coordinate(2, row / plan.size[1]);
        for (std::size_t i = 0; i < width; ++i)
            batch.set(i, coordinate(0, i), y, z);
        batch.pad();
        batch.evaluate(function, uniforms.points<double>(), [] { return false; });
        for (std::size_t i = 0; i < width; ++i)
            (*numbers)[row * width + i] = static_cast<float>(batch.f(i));
    });
    return {.type = SampleType::Float,
            .size = plan.size,
            .data = std::shared_ptr<const void>(numbers, numbers->data())};
}

}  // namespace zeroset
