#pragma once

#include "engine/trace/voxels/ray_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace zeroset {

/// Depths on a ray.
struct LayerStretch {
    double from, to;
};

/// Calls `look(cell, stretch)` for the cells of a layer that a ray is in on a stretch, front to
/// back, until it returns true; whether it did. The cells may be beside the grid.
template <class Look>
bool walk_cells(const IndexRays::Ray& ray, const WalkAxes& axes, std::int32_t layer,
                const LayerStretch& whole, const Look& look) {
    const auto& at = ray.at;
    const auto& along = ray.along;
    const auto cell_of = [&](std::size_t axis, double s) {
        return static_cast<std::int32_t>(std::floor(at[axis] + s * along[axis]));
    };
    std::array<std::int32_t, 3> cell{};
    cell[axes.i] = cell_of(axes.i, whole.from);
    cell[axes.j] = cell_of(axes.j, whole.from);
    cell[axes.k] = layer;
    if (cell[axes.i] == cell_of(axes.i, whole.to) && cell[axes.j] == cell_of(axes.j, whole.to))
        return look(cell, whole);
    const auto leaves = [&](std::size_t axis) {
        if (along[axis] == 0) return std::numeric_limits<double>::infinity();
        return (cell[axis] + (along[axis] > 0 ? 1 : 0) - at[axis]) / along[axis];
    };
    double from = whole.from;
    double leaves_i = leaves(axes.i);
    double leaves_j = leaves(axes.j);
    for (;;) {
        const double to = std::max(from, std::min({whole.to, leaves_i, leaves_j}));
        if (look(cell, {.from = from, .to = to})) return true;
        if (!(to < whole.to)) return false;
        from = to;
        const std::size_t axis = leaves_i <= leaves_j ? axes.i : axes.j;
        cell[axis] += along[axis] > 0 ? 1 : -1;
        (axis == axes.i ? leaves_i : leaves_j) = leaves(axis);
    }
}

}  // namespace zeroset
