#pragma once

#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/scalar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace zeroset {

/// The box about cell i of a frustum, as item `at`; `in_rays`: the cell has no width. In upward
/// rounding.
template <class Real, std::size_t cell_room, std::size_t box_room>
void put_box_of_cell(const FormCells<Real, cell_room>& cells, std::size_t i,
                     const FrustumOf<Real>& frustum, bool in_rays,
                     RangeBoxes<Real, box_room>& boxes, std::size_t at) {
    // Coordinates of a RaysOf or in a form are off by less, in parts of their terms.
    constexpr double unit = 8.0 * static_cast<double>(std::numeric_limits<Real>::epsilon());
    const auto number = [](Real of) { return static_cast<double>(of); };
    const double u = number(cells.u[i]);
    const double v = number(cells.v[i]);
    const double s = number(cells.s[i]);
    const double radius = number(cells.s_radius[i]);
    const double from_eye = std::abs(number(frustum.distance) + s) + radius;
    for (std::size_t k = 0; k < 3; ++k) {
        const double right = number(frustum.right[k]);
        const double up = number(frustum.up[k]);
        const double across = u * right + v * up;
        const double along = number(frustum.forward[k]) + across;
        const double middle =
            number(frustum.base[k]) + number(frustum.distance) * across + s * along;
        const double aside =
            std::abs(right) * number(frustum.u_radius) + std::abs(up) * number(frustum.v_radius);
        const double size =
            number(frustum.size[k]) + (std::abs(s) + radius) * number(frustum.direction_size[k]);
        const double reach =
            std::abs(along) * radius + (in_rays ? 0.0 : aside * from_eye) + unit * size;
        boxes.ends[k][at] = upper_end(Real{}, reach - middle);
        boxes.ends[k + 3][at] = upper_end(Real{}, reach + middle);
    }
}

/// Asks for f's sign where the forms of the first `count` cells tell nothing, because f leaves the
/// range of its type in them, or comes near a pole: by ranges over the boxes about them. Where f
/// surely has a sign, its form becomes 1 or -1, which tells no more than that. Returns how many
/// boxes were asked about. `in_rays`: the cells have no width. In upward rounding.
template <class Real, std::size_t capacity>
std::size_t ask_unknown_signs(const KernelFunction<RangeBatchOf<Real>>& range,
                              const FrustumOf<Real>& frustum, bool in_rays, const Real* uniforms,
                              std::size_t count, FormCells<Real, capacity>& cells) {
    constexpr Real unknown = std::numeric_limits<Real>::infinity();
    // Seldom: all cells are looked at in one go first.
    bool all_known = true;
    for (std::size_t i = 0; i < count; ++i)
        all_known = all_known & (cells.e[i] < unknown);
    if (all_known) return 0;
    std::array<std::size_t, capacity> asked{};
    RangeBoxes<Real, capacity> boxes;
    std::size_t size = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (cells.e[i] < unknown || cells.nowhere[i] != 0) continue;
        put_box_of_cell(cells, i, frustum, in_rays, boxes, size);
        asked[size++] = i;
    }
    if (size == 0) return 0;
    boxes.pad(size);
    range(boxes.batch(padded(size), uniforms));
    for (std::size_t n = 0; n < size; ++n) {
        if (!boxes.excludes_zero(n)) continue;
        const std::size_t i = asked[n];
        cells.c[i] = boxes.f_neg_lo[n] < 0 ? Real{1} : Real{-1};
        cells.e[i] = 0;
    }
    return size;
}

}  // namespace zeroset
