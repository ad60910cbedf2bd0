#pragma once

#include "engine/trace/voxels/ray_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace zeroset {

/// The planes of a grid's outermost samples. Rays that stay in one of them, as far as places are
/// known, are in the cells beside it.
class GridBorders {
public:
    GridBorders(const IndexRays& rays, const std::array<std::int32_t, 3>& last_cell)
        : rays_(rays), last_cell_(last_cell) {}

    /// Whether rays no farther from the one in the middle may stay in a plane.
    [[nodiscard]] bool may_hold(const IndexRays::Ray& middle, double u_radius,
                                double v_radius) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double reach =
                std::abs(rays_.right[axis]) * u_radius + std::abs(rays_.up[axis]) * v_radius;
            if (std::abs(middle.along[axis]) <= 2 * (reach + flat * steepest_of(middle)))
                return true;
        }
        return false;
    }
    [[nodiscard]] bool hold(const IndexRays::Ray& ray) const {
        return place_in(ray, 0) || place_in(ray, 1) || place_in(ray, 2);
    }
    /// Moves a ray of a plane into the cells beside it.
    void take_in(IndexRays::Ray& ray) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto place = place_in(ray, axis);
            if (!place) continue;
            ray.at[axis] = *place;
            ray.along[axis] = 0;
        }
    }

private:
    static constexpr double flat = 0x1p-50;  ///< along an axis, in parts of the steepest slope
    static double steepest_of(const IndexRays::Ray& ray) {
        return std::max({std::abs(ray.along[0]), std::abs(ray.along[1]), std::abs(ray.along[2])});
    }
    /// Where in the cells along an axis a ray is that stays in a plane; nothing for others.
    [[nodiscard]] std::optional<double> place_in(const IndexRays::Ray& ray,
                                                 std::size_t axis) const {
        if (!(std::abs(ray.along[axis]) <= flat * steepest_of(ray))) return std::nullopt;
        const double upper = last_cell_[axis] + 1.0;
        const double slack = 0x1p-46 * (upper + std::abs(rays_.base[axis]));
        if (std::abs(ray.at[axis]) <= slack) return 0.0;
        if (std::abs(ray.at[axis] - upper) <= slack) return std::nextafter(upper, 0.0);
        return std::nullopt;
    }

    const IndexRays& rays_;
    const std::array<std::int32_t, 3>& last_cell_;
};

}  // namespace zeroset
