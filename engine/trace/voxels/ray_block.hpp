#pragma once

#include "engine/trace/tile_rays.hpp"
#include "engine/volume/geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// The rays of a tile in indices of samples: the point at depth s on the ray of (u, v) is
/// at(u, v) + s along(u, v), linear in u and v.
struct IndexRays {
    IndexRays() = default;
    IndexRays(const TileRays& rays, const IndexMap& map);

    struct Ray {
        std::array<double, 3> at, along;
    };
    [[nodiscard]] Ray ray(double u, double v) const {
        Ray ray{};
        for (std::size_t i = 0; i < 3; ++i) {
            ray.at[i] = base[i] + distance * (u * right[i] + v * up[i]);
            ray.along[i] = forward[i] + (u * right[i] + v * up[i]);
        }
        return ray;
    }

    std::array<double, 3> base{}, right{}, up{}, forward{};
    double distance = 0;
};

/// Cells of a layer of a grid, across two of its axes, both ends included.
struct CellRectangle {
    std::int32_t i_first, i_last, j_first, j_last;

    [[nodiscard]] bool empty() const { return i_first > i_last || j_first > j_last; }
    [[nodiscard]] CellRectangle common(const CellRectangle& other) const {
        return {.i_first = std::max(i_first, other.i_first),
                .i_last = std::min(i_last, other.i_last),
                .j_first = std::max(j_first, other.j_first),
                .j_last = std::min(j_last, other.j_last)};
    }
};

/// The three axes of a grid as a block of rays sees them: it goes along `k`.
struct WalkAxes {
    std::size_t i, j, k;
};

/// A bundle of rays between four, along the axis of the grid that these are nearest to: where it
/// crosses the layers of cells across that axis.
class RayBlock {
public:
    /// The rays with |u - u_middle| and |v - v_middle| up to the radii, between two depths.
    /// `last_cell`: of the grid.
    RayBlock(const IndexRays& rays, double u, double v, double u_radius, double v_radius,
             double from, double to, const std::array<std::int32_t, 3>& last_cell);

    /// A bundle that meets nothing.
    static RayBlock nothing() {
        RayBlock block;
        block.usable_ = true;
        return block;
    }

    /// Whether the walk knows what these rays meet: no ray goes nearly across the axis.
    [[nodiscard]] bool usable() const { return usable_; }
    [[nodiscard]] const WalkAxes& axes() const { return axes_; }
    /// 1 or -1: whether layers go up or down along the rays.
    [[nodiscard]] int step() const { return step_; }
    /// The first and the last layer that rays are in; none where `empty`.
    [[nodiscard]] std::int32_t first_layer() const { return first_layer_; }
    [[nodiscard]] std::int32_t last_layer() const { return last_layer_; }
    [[nodiscard]] bool empty() const { return (last_layer_ - first_layer_) * step_ < 0; }
    /// The cells that the rays are in between two layers, both included, and some about them.
    [[nodiscard]] CellRectangle cells(std::int32_t low, std::int32_t high) const;
    /// The least depth at which a ray of the bundle enters a layer.
    [[nodiscard]] double depth_at(std::int32_t layer) const;

private:
    RayBlock() = default;

    /// Where the places across the axis are, as a line in the place along it.
    struct Line {
        double at, slope;

        [[nodiscard]] double operator()(double k) const { return at + slope * k; }
    };
    struct Corner {
        Line i, j;
        Line depth;
    };

    WalkAxes axes_{};
    std::array<Corner, 4> corners_{};
    std::array<std::int32_t, 3> last_cell_{};
    std::int32_t first_layer_ = 0, last_layer_ = -1;
    int step_ = 1;
    bool usable_ = false;
};

}  // namespace zeroset
