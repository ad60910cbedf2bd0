#pragma once

#include "engine/real/field_answers.hpp"
#include "engine/volume/geometry.hpp"
#include "engine/volume/pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// A bound of the terms of which index `i` of a point is made, for coordinates of these sizes.
inline double terms_of(const IndexMap& map, std::size_t i, const std::array<double, 3>& sizes) {
    double sum = std::abs(map.shift[i]);
    for (std::size_t c = 0; c < 3; ++c) {
        if (map.index_from_world[i][c] != 0) sum += std::abs(map.index_from_world[i][c]) * sizes[c];
    }
    return sum;
}

inline std::array<double, 3> sizes_of(const std::array<double, 3>& point) {
    return {std::abs(point[0]), std::abs(point[1]), std::abs(point[2])};
}

/// Number of roundings in `index_of` and bounds of it, amply counted.
inline constexpr double index_roundings = 8;

/// Index `i` of a point, off by less than index_roundings * unit_of<Wide> * terms_of.
template <class Wide>
Wide index_of(const IndexMap& map, std::size_t i, const std::array<double, 3>& point) {
    Wide index = map.shift[i];
    for (std::size_t c = 0; c < 3; ++c) {
        if (map.index_from_world[i][c] != 0)
            index += Wide{map.index_from_world[i][c]} * Wide{point[c]};
    }
    return index;
}

/// The indices over a box in the world, rounded outward, and of them those in the grid.
struct IndexBox {
    std::array<double, 3> from, to;  ///< within the grid
    CellSpan cells;                  ///< that hold them
    std::array<double, 3> terms;     ///< bounds as terms_of
    std::array<bool, 3> leaves;      ///< whether it may reach beyond the grid along the axis
    std::array<bool, 3> outside;     ///< whether it is surely all beyond the grid along the axis

    [[nodiscard]] bool surely_inside() const { return !leaves[0] && !leaves[1] && !leaves[2]; }
    [[nodiscard]] bool surely_outside() const { return outside[0] || outside[1] || outside[2]; }
    /// How many samples are about it along the axis.
    [[nodiscard]] std::size_t samples(std::size_t axis) const {
        return static_cast<std::size_t>(cells.last[axis] - cells.first[axis]) + 2;
    }
};

/// NaN in the box means that nothing is known of that end.
inline IndexBox index_box(const IndexMap& map, const GridSize& size,
                          const std::array<double, 3>& lo, const std::array<double, 3>& hi) {
    IndexBox box{};
    const std::array<double, 3> sizes{std::max(std::abs(lo[0]), std::abs(hi[0])),
                                      std::max(std::abs(lo[1]), std::abs(hi[1])),
                                      std::max(std::abs(lo[2]), std::abs(hi[2]))};
    for (std::size_t i = 0; i < 3; ++i) {
        double from = map.shift[i];
        double to = map.shift[i];
        for (std::size_t c = 0; c < 3; ++c) {
            const double m = map.index_from_world[i][c];
            if (m == 0) continue;
            from += m * (m > 0 ? lo[c] : hi[c]);
            to += m * (m > 0 ? hi[c] : lo[c]);
        }
        box.terms[i] = terms_of(map, i, sizes);
        const double error = index_roundings * unit_of<double> * box.terms[i];
        from -= error;
        to += error;
        const double end = static_cast<double>(size[i]) - 1;
        box.leaves[i] = !(from >= 0 && to <= end);
        box.outside[i] = from > end || to < 0;
        box.from[i] = from >= 0 ? std::min(from, end) : 0;
        box.to[i] = to <= end ? std::max(to, 0.0) : end;
        const auto last_cell = static_cast<std::int64_t>(size[i]) - 2;
        box.cells.first[i] = std::min(static_cast<std::int64_t>(box.from[i]), last_cell);
        const auto last = static_cast<std::int64_t>(std::ceil(box.to[i])) - 1;
        box.cells.last[i] = std::clamp(last, box.cells.first[i], last_cell);
    }
    return box;
}

}  // namespace zeroset
