#pragma once

#include "engine/kernel/form_cells.hpp"
#include "papers/octree/octree_ray.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

// The inclusion functions of the partial derivatives [Stolte05, fig. 4]: slopes of beam forms over
// octants, seen along an axis from so far away that the rays are nearly parallel to it.

namespace zeroset {

/// How far, in lengths of an octant, the way along three such rays from a point of it may end
/// beside a corner, or leave it; a bound with room to spare.
inline constexpr double slope_slant = 0x1p-50;

/// Puts these boxes, and a little around each, into cells of a frustum along `axis`; the cells'
/// df/ds are then the partial derivatives. In upward rounding.
///
/// The eye is 2^56 times as far away as all boxes reach: a ray at y from the axis is at y + s y / D
/// at depth s, which moves it by less than 2^-55 of that reach.
template <class Real, std::size_t capacity>
FrustumOf<Real> slope_frustum(std::span<const RayBox> boxes, int axis,
                              FormCells<Real, capacity>& cells) {
    const int across[2] = {(axis + 1) % 3, (axis + 2) % 3};
    double reach = 0.0;
    for (const RayBox& box : boxes) {
        for (int i = 0; i < 3; ++i)
            reach = std::max({reach, std::abs(box.neg_lo[i]), std::abs(box.hi[i])});
    }
    const double distance = std::ldexp(1.0, std::ilogb(reach) + 57);
    const double aside = 0x1p-54 * reach;
    // A cell's middle is rounded to Real; its radius holds the rounding.
    const auto middle = [&](const RayBox& box, int i, double scale, double& radius) {
        const double place = 0.5 * (box.hi[i] - box.neg_lo[i]);
        const auto rounded = static_cast<Real>(place / scale);
        const double off = std::abs(static_cast<double>(rounded) * scale - place);
        radius = std::max(radius, 0.5 * (box.hi[i] + box.neg_lo[i]) + off + aside);
        return rounded;
    };
    double u_radius = 0.0;
    double v_radius = 0.0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        double s_radius = 0.0;
        cells.u[i] = middle(boxes[i], across[0], distance, u_radius);
        cells.v[i] = middle(boxes[i], across[1], distance, v_radius);
        cells.s[i] = middle(boxes[i], axis, 1.0, s_radius);
        cells.s_radius[i] = static_cast<Real>(s_radius);  // rounded upward
    }
    for (auto* const column : {&cells.u, &cells.v, &cells.s, &cells.s_radius})
        std::fill(column->begin() + static_cast<std::ptrdiff_t>(boxes.size()),
                  column->begin() + static_cast<std::ptrdiff_t>(padded(boxes.size())),
                  column->front());
    FrustumOf<Real> frustum{};
    frustum.forward[axis] = 1;
    frustum.right[across[0]] = 1;
    frustum.up[across[1]] = 1;
    frustum.distance = static_cast<Real>(distance);
    frustum.u_radius = static_cast<Real>(u_radius / distance);
    frustum.v_radius = static_cast<Real>(v_radius / distance);
    for (const int i : across) {
        frustum.size[i] = static_cast<Real>(2.0 * reach);
        frustum.direction_size[i] = static_cast<Real>(2.0 * reach / distance);
    }
    frustum.direction_size[axis] = 1;
    return frustum;
}

}  // namespace zeroset
