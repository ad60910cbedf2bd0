#pragma once

#include "engine/trace/tile_rays.hpp"
#include "engine/trace/voxels/lane_roots.hpp"
#include "engine/trace/voxels/level_grid.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// Rays of a bundle, a bit each, on which f was above or below 0 where it was known last.
struct BundleSides {
    std::uint64_t above = 0, below = 0;
};

/// Takes rays of a bundle through the layers of a trilinear grid, some at once.
class LaneWalk {
public:
    /// The pixel of a bundle's first ray, in the tile.
    struct Corner {
        int col, row;
    };
    void begin(const TileRays& rays, const Corner& corner) {
        for (std::size_t at = 0; at < block_size; ++at) {
            u_[at] = rays.u(corner.col + static_cast<double>(at));
            v_[at] = rays.v(corner.row + static_cast<double>(at));
        }
        sides_ = {};
    }
    [[nodiscard]] bool was_above(std::size_t ray) const { return (sides_.above >> ray & 1U) != 0; }
    [[nodiscard]] bool was_below(std::size_t ray) const { return (sides_.below >> ray & 1U) != 0; }

    /// Calls `on_cell(ray)` for each cell that is evaluated, `tell(ray, rays, lane)` for each root.
    /// Returns the rays of which nothing is known in this layer.
    template <class Grid, class OnCell, class Tell>
    std::uint64_t walk(const BundleSearch& search, const Grid& grid, const CellMask& mask,
                       std::uint64_t some, const OnCell& on_cell, const Tell& tell) {
        std::uint64_t unclear = 0;
        while (some != 0) {
            some = take(some);
            unclear |= walk_taken(search, grid, mask, on_cell, tell);
        }
        return unclear;
    }

private:
    template <class Take>
    static void for_each_lane(std::uint32_t lanes, const Take& take) {
        for (; lanes != 0; lanes &= lanes - 1)
            take(static_cast<std::size_t>(std::countr_zero(lanes)));
    }
    /// Takes the first of these rays into the lanes; returns the others.
    std::uint64_t take(std::uint64_t some) {
        rays_.count = 0;
        for (; some != 0 && rays_.count < LaneRays::most; some &= some - 1) {
            const auto ray = static_cast<std::size_t>(std::countr_zero(some));
            rays_.ray[rays_.count] = static_cast<std::uint8_t>(ray);
            rays_.u[rays_.count] = u_[ray % block_size];
            rays_.v[rays_.count] = v_[ray / block_size];
            ++rays_.count;
        }
        return some;
    }
    [[nodiscard]] LaneSides sides_of_lanes() const {
        LaneSides sides;
        for (std::size_t lane = 0; lane < rays_.count; ++lane) {
            sides.above |= static_cast<std::uint32_t>(was_above(rays_.ray[lane])) << lane;
            sides.below |= static_cast<std::uint32_t>(was_below(rays_.ray[lane])) << lane;
        }
        return sides;
    }
    [[nodiscard]] std::uint64_t of_bundle(std::uint32_t lanes) const {
        std::uint64_t result = 0;
        for_each_lane(lanes,
                      [&](std::size_t lane) { result |= std::uint64_t{1} << rays_.ray[lane]; });
        return result;
    }
    template <class Grid, class OnCell, class Tell>
    std::uint64_t walk_taken(const BundleSearch& search, const Grid& grid, const CellMask& mask,
                             const OnCell& on_cell, const Tell& tell) {
        const std::uint32_t all = (1U << rays_.count) - 1;
        LaneSides sides = sides_of_lanes();
        std::uint32_t left = enter_layer(search, mask.layer, rays_);
        std::uint32_t unclear = all & ~left;
        while (left != 0) {
            const std::uint32_t held = take_cells(search.axes, grid, mask, left, on_cell);
            if (held != 0) {
                const std::uint32_t roots = find_roots(search, held, rays_, sides, unclear);
                for_each_lane(roots, [&](std::size_t lane) { tell(rays_.ray[lane], rays_, lane); });
                left &= ~(roots | unclear);
            }
            if (left != 0) left = next_cells(search, left, rays_);
        }
        // Keep the former sides of unclear rays: they are looked at again.
        const std::uint64_t above = of_bundle(sides.above & ~unclear);
        const std::uint64_t below = of_bundle(sides.below & ~unclear);
        sides_.above |= above;
        sides_.below |= below;
        return of_bundle(unclear);
    }
    /// Takes the corners of those of the lanes' cells that may hold the level.
    template <class Grid, class OnCell>
    std::uint32_t take_cells(const WalkAxes& axes, const Grid& grid, const CellMask& mask,
                             std::uint32_t lanes, const OnCell& on_cell) {
        std::uint32_t held = 0;
        for_each_lane(lanes, [&](std::size_t lane) {
            std::array<std::int32_t, 3> cell{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                cell[axis] = static_cast<std::int32_t>(rays_.cell[axis][lane]);
            if (!mask.may_hold(cell[axes.i], cell[axes.j])) return;
            held |= 1U << lane;
            on_cell(rays_.ray[lane]);
            const auto corners = grid.numbers(cell);
            for (std::size_t corner = 0; corner < 8; ++corner)
                rays_.corners[corner][lane] = corners[corner];
        });
        return held;
    }

    LaneRays rays_;
    std::array<double, block_size> u_{}, v_{};
    BundleSides sides_;
};

}  // namespace zeroset
