// The first roots of a plain isosurface, voxel by voxel, proved.
//   index    places in the grid: sample (i, j, k) is at (i, j, k), a cell between eight of them
//   layer    the cells between two neighbouring slices of samples, across the axis k of the grid
//            that rays are nearest to
//   slab     some layers, one behind the other
// Bundles of 8 x 8 rays go through the pyramid of minima and maxima together: its bricks between
// the bundle's outermost rays are looked at slab by slab, front to back. In a slab of four layers
// that may hold the level, the cells that may are marked by a bit each, for all rays at once. In
// each cell f is a cubic along a ray, of which Bernstein coefficients tell all: in floats, a ray a
// lane, they exclude most layers (block_lanes.cpp). In the others rays go through the marked cells
// in double: many at once where that tells all (lane_roots.cpp), else one by one (ray_cubic.hpp).
//
// What is proved: in double, numbers are known to +-error (`GridBounds`), and places to less than
// that changes f by. A ray that slips by rounding through the edge of another cell than those it is
// looked for in is there for so short a stretch that f changes by less than `error`, so a stretch
// on which f is farther from 0 than that has no root beside it either.

#pragma once

#include "engine/trace/ray_lines.hpp"
#include "engine/trace/tile_costs.hpp"
#include "engine/trace/voxels/block_walk.hpp"
#include "engine/trace/voxels/grid_borders.hpp"
#include "engine/trace/voxels/lane_walk.hpp"
#include "engine/trace/voxels/layer_walk.hpp"
#include "engine/trace/voxels/open_ray.hpp"
#include "engine/trace/voxels/spline_ray.hpp"
#include "engine/trace/voxels/voxel_hits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace zeroset {

/// The rays of a tile in a grid of numbers.
template <class Sample, std::size_t support>
class VoxelTile {
public:
    using Grid = LevelGrid<Sample, support>;

    VoxelTile(const TraceFrame& frame, const Tile& tile, const Volume& volume, const Grid& grid,
              double error, RayLines& lines, TileHits& hits, Counters& counters)
        : frame_(frame),
          tile_(tile),
          rays_(frame, tile),
          map_(volume.data().map()),
          index_rays_(rays_, map_),
          error_(error),
          grid_(grid),
          lines_(lines),
          hits_(frame, rays_, lines_, map_, hits, counters),
          counters_(counters) {
        for (std::size_t i = 0; i < 3; ++i)
            last_cell_[i] = static_cast<std::int32_t>(volume.data().samples().size[i]) - 2;
        lines_.begin_singly(frame, std::numeric_limits<float>::digits);
    }

    /// Traces the tile; false: bundles cannot go through the grid from here.
    bool run() {
        const bool done = run_bundles();
        counters_.value += evaluations_;
        return done;
    }

private:
    /// Some pixels of the tile.
    struct Pixels {
        int col, row, cols, rows;
    };

    bool run_bundles() {
        const Pixels all{.col = 0, .row = 0, .cols = tile_.cols, .rows = tile_.rows};
        const DepthRange depths = depths_of(all);
        const RayBlock whole = block_of(all, depths, -std::numeric_limits<double>::infinity());
        if (!whole.usable()) return false;
        const double from = first_depth(whole);
        count(all, 1);
        if (!std::isfinite(from)) return true;
        if (tile_.limits == nullptr)
            finest_ = lines_.least_finest(rays_, tile_.cols, tile_.rows, depths.enter_lo);
        // Trace the bundles that meet the grid.
        for (int row = 0; row < tile_.rows; row += block_size) {
            for (int col = 0; col < tile_.cols; col += block_size) {
                const Pixels pixels{.col = col,
                                    .row = row,
                                    .cols = std::min(block_size, tile_.cols - col),
                                    .rows = std::min(block_size, tile_.rows - row)};
                inside_ = depths_of(pixels);
                const RayBlock block = block_of(pixels, inside_, from);
                if (frame_.stopped() || !block.usable()) {
                    hits_.leave(pixels.col, pixels.row, pixels.cols, pixels.rows);
                } else if (!block.empty()) {
                    trace(pixels, block);
                }
            }
        }
        return true;
    }
    struct Middle {
        double u, v, u_radius, v_radius;
    };
    [[nodiscard]] Middle middle_of(const Pixels& pixels) const {
        return {.u = rays_.u(pixels.col + 0.5 * (pixels.cols - 1)),
                .v = rays_.v(pixels.row + 0.5 * (pixels.rows - 1)),
                .u_radius = 0.5 * pixels.cols * rays_.pixel(),
                .v_radius = 0.5 * pixels.rows * rays_.pixel()};
    }
    /// Where the rays of some pixels are inside the region.
    [[nodiscard]] DepthRange depths_of(const Pixels& pixels) const {
        const Middle middle = middle_of(pixels);
        return rays_.depths(middle.u, middle.v, middle.u_radius, middle.v_radius);
    }
    /// The rays of some pixels, from a depth on.
    [[nodiscard]] RayBlock block_of(const Pixels& pixels, const DepthRange& depths,
                                    double from) const {
        if (depths.empty()) return RayBlock::nothing();
        const Middle middle = middle_of(pixels);
        return {index_rays_,
                middle.u,
                middle.v,
                middle.u_radius,
                middle.v_radius,
                std::max(from, depths.enter_lo),
                std::max(from, depths.exit_hi),
                last_cell_};
    }
    /// Where rays first come to bricks that may hold the level, at most; +inf: nowhere.
    [[nodiscard]] double first_depth(const RayBlock& block) const {
        double depth = std::numeric_limits<double>::infinity();
        walk_block(grid_, block, [&](const CellRectangle&, const LayerRange& layers) {
            depth = block.depth_at(block.step() > 0 ? layers.low : layers.high);
            return false;
        });
        return depth;
    }
    void count(const Pixels& pixels, std::uint64_t evaluations) {
        counters_.range += evaluations;
        if (counters_.costs != nullptr) {
            counters_.costs->add(pixels.col, pixels.row, pixels.cols, pixels.rows,
                                 static_cast<double>(evaluations));
        }
    }

    void trace(const Pixels& pixels, const RayBlock& block) {
        const std::uint64_t in_row = (std::uint64_t{1} << pixels.cols) - 1;
        open_ = 0;
        for (int y = 0; y < pixels.rows; ++y)
            open_ |= in_row << (y * block_size);
        begun_ = 0;
        unsure_ = 0;
        first_ = pixels;
        has_columns_ = false;
        border_ = rays_in_border(pixels);
        lanes_.begin(rays_, {.col = pixels.col, .row = pixels.row});
        std::uint64_t evaluations = 0;
        walk_block(grid_, block, [&](const CellRectangle& cells, const LayerRange& layers) {
            ++evaluations;
            walk_slab(cells, layers, block);
            return open_ != 0;
        });
        count(pixels, evaluations);
        for_each_bit(open_ & begun_, [&](std::size_t ray) {
            if (bundle_[ray].root.finish()) tell(bundle_[ray]);
        });
    }
    template <class Take>
    static void for_each_bit(std::uint64_t bits, const Take& take) {
        for (; bits != 0; bits &= bits - 1)
            take(static_cast<std::size_t>(std::countr_zero(bits)));
    }
    /// The rays of a bundle that stay in a plane of the grid's outermost samples.
    [[nodiscard]] std::uint64_t rays_in_border(const Pixels& pixels) const {
        const Middle middle = middle_of(pixels);
        const GridBorders borders(index_rays_, last_cell_);
        std::uint64_t found = 0;
        if (!borders.may_hold(index_rays_.ray(middle.u, middle.v), middle.u_radius,
                              middle.v_radius))
            return found;
        for_each_bit(open_, [&](std::size_t at) {
            if (borders.hold(ray_at(at))) found |= bit(at);
        });
        return found;
    }
    [[nodiscard]] IndexRays::Ray ray_at(std::size_t at) const {
        return index_rays_.ray(rays_.u(first_.col + static_cast<int>(at) % block_size),
                               rays_.v(first_.row + static_cast<int>(at) / block_size));
    }
    void make_columns_of(const RayBlock& block) {
        if (has_columns_) return;
        has_columns_ = true;
        steepest_ = make_columns(index_rays_, block.axes(), rays_.u(first_.col),
                                 rays_.v(first_.row), rays_.pixel(), columns_);
    }
    /// Takes the open rays through the layers of a slab.
    void walk_slab(const CellRectangle& cells, const LayerRange& layers, const RayBlock& block) {
        static_assert(1 << Grid::lowest_shift == CellMask::most_layers);
        const WalkAxes& axes = block.axes();
        make_columns_of(block);
        // Narrow the slab to cells near open rays whose bricks may hold the level.
        const RayReach reach(columns_, layers, open_);
        const CellRectangle near = cells.common(reach.cells(layers.low, layers.high));
        if (near.empty()) return;
        const CellRectangle held = grid_.in_bricks(near, layers, axes);
        if (held.empty()) return;
        // Begin the marks of cells, where these are few enough.
        const bool marks = CellMask::fits(held);
        if (marks) grid_.begin(held, layers, axes, mask_);
        const bool at_once = marks && mask_.is_small() && steepest_ <= 1.5;
        if (at_once) count_from(columns_, held.i_first, held.j_first, layers.low, slab_rays_);
        const int step = block.step();
        // Take the rays through layers that may hold the level, front to back.
        for (std::int32_t layer = step > 0 ? layers.low : layers.high;
             layer >= layers.low && layer <= layers.high && open_ != 0; layer += step) {
            if (marks) grid_.mark(layer, reach, axes, mask_);
            if (marks && !mask_.any) continue;
            for_each_bit(at_once ? near_level(axes) : open_, [&](std::size_t at) {
                const bool in_border = (border_ & bit(at)) != 0;
                if (marks && !at_once && !in_border && !may_hold(at)) return;
                walk(at, marks, layer, axes);
            });
        }
    }
    void walk(std::size_t at, bool marks, std::int32_t layer, const WalkAxes& axes) {
        if (!begin(at, axes) || walk_layer(bundle_[at], marks, layer, axes)) {
            open_ &= ~bit(at);
        } else if (bundle_[at].root.is_open()) {
            unsure_ |= bit(at);
        }
    }
    static std::uint64_t bit(std::size_t ray) { return std::uint64_t{1} << ray; }
    /// The open rays that may be at the level in the marked layer, or on entering it, and that are
    /// not settled by walk_at_once.
    std::uint64_t near_level(const WalkAxes& axes) {
        const NearCells marked = mask_.near(steepest_);
        const AskedLayer asked{.samples = mask_.samples,
                               .marked = marked,
                               .layer = static_cast<std::size_t>(mask_.layer - mask_.layers.low),
                               .rows = mask_.rows,
                               .is_spline = support == 4,
                               .error = mask_.error};
        const std::uint64_t unsure = std::exchange(unsure_, 0);
        const std::uint64_t near =
            open_ & (unsure | border_ | rays_at_level(slab_rays_, asked, open_));
        const std::uint64_t singly = near & (begun_ | border_);
        const std::uint64_t fresh = near & ~singly;
        return singly | (fresh != 0 ? walk_at_once(fresh, axes) : 0);
    }
    /// Takes rays that have not begun through the marked layer; returns those left to go singly.
    std::uint64_t walk_at_once(std::uint64_t some, const WalkAxes& axes) {
        if constexpr (support == 2) {
            if (!(finest_ > 0)) return some;
            // Walk rays singly until a hit has told the sign of f's gradient.
            for (; some != 0 && hits_.sign() == 0; some &= some - 1)
                walk(static_cast<std::size_t>(std::countr_zero(some)), true, mask_.layer, axes);
            const BundleSearch search{.rays = index_rays_,
                                      .map = map_,
                                      .axes = axes,
                                      .enter = inside_.enter_hi,
                                      .exit = inside_.exit_lo,
                                      .error = error_,
                                      .finest = finest_,
                                      .look_distance = rays_.look_distance(),
                                      .sign = static_cast<double>(hits_.sign())};
            return lanes_.walk(
                search, grid_, mask_, some,
                [&](std::size_t ray) { count_evaluation(pixel_of(ray)); },
                [&](std::size_t ray, const LaneRays& rays, std::size_t lane) {
                    open_ &= ~bit(ray);
                    hits_.tell_certified(
                        pixel_of(ray), rays.distance[lane],
                        {rays.gradient[0][lane], rays.gradient[1][lane], rays.gradient[2][lane]});
                });
        } else {
            return some;
        }
    }
    [[nodiscard]] std::uint32_t pixel_of(std::size_t ray) const {
        const int col = first_.col + static_cast<int>(ray) % block_size;
        const int row = first_.row + static_cast<int>(ray) / block_size;
        return static_cast<std::uint32_t>(row * tile_size + col);
    }
    void count_evaluation(std::uint32_t pixel) {
        ++evaluations_;
        if (counters_.costs != nullptr) counters_.costs->add(pixel);
    }
    /// Makes a ray when it first comes near the surface; false: the region is nowhere on it.
    bool begin(std::size_t at, const WalkAxes& axes) {
        if ((begun_ & bit(at)) != 0) return true;
        const int col = first_.col + static_cast<int>(at) % block_size;
        const int row = first_.row + static_cast<int>(at) / block_size;
        if (!lines_.take(tile_, rays_, col, row)) return false;
        const std::uint32_t pixel = pixel_of(at);
        const RayLine& line = lines_.of(pixel);
        IndexRays::Ray ray = ray_at(at);
        GridBorders(index_rays_, last_cell_).take_in(ray);
        bundle_[at] = {.pixel = pixel,
                       .ray = ray,
                       .per_layer = 1 / ray.along[axes.k],
                       .from = line.from,
                       .to = line.to,
                       .root = FirstRoot(error_, lines_.finest(line, line.from))};
        if (lanes_.was_above(at)) bundle_[at].root.begin_above();
        if (lanes_.was_below(at)) bundle_[at].root.begin_below();
        begun_ |= bit(at);
        return true;
    }

    /// Whether the level may be in a cell of the marked layer that the ray is in.
    [[nodiscard]] bool may_hold(std::size_t at) const {
        const double i = columns_.i_at[at] + columns_.i_slope[at] * mask_.layer;
        const double j = columns_.j_at[at] + columns_.j_slope[at] * mask_.layer;
        const double beyond_i = i + columns_.i_slope[at];
        const double beyond_j = j + columns_.j_slope[at];
        return mask_.may_hold_between(std::min(i, beyond_i), std::max(i, beyond_i),
                                      std::min(j, beyond_j), std::max(j, beyond_j));
    }
    /// Takes the ray through the cells of a layer; whether it has ended.
    bool walk_layer(OpenRay& ray, bool marks, std::int32_t layer, const WalkAxes& axes) {
        const LayerStretch whole = ray.stretch_in(layer, axes.k);
        if (!(whole.from <= whole.to)) return whole.from >= ray.to && end(ray);
        return walk_cells(
            ray.ray, axes, layer, whole,
            [&](const std::array<std::int32_t, 3>& cell, const LayerStretch& stretch) {
                const std::int32_t i = cell[axes.i];
                const std::int32_t j = cell[axes.j];
                const bool inside =
                    i >= 0 && i <= last_cell_[axes.i] && j >= 0 && j <= last_cell_[axes.j];
                return inside && (!marks || mask_.may_hold(i, j)) && search(ray, cell, stretch);
            });
    }
    /// Ends a ray that has left the region.
    bool end(OpenRay& ray) {
        if (ray.root.finish()) tell(ray);
        return true;
    }
    /// Searches the ray in a cell; whether it has ended.
    bool search(OpenRay& ray, const std::array<std::int32_t, 3>& cell,
                const LayerStretch& stretch) {
        const auto place = [&](double s) {
            std::array<double, 3> in_cell{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                in_cell[axis] = ray.ray.at[axis] + s * ray.ray.along[axis] - cell[axis];
            return in_cell;
        };
        count_evaluation(ray.pixel);
        const auto f = ray_polynomial(grid_.numbers(cell), place(stretch.from), place(stretch.to),
                                      stretch.from, stretch.to);
        if (!ray.root.look(f)) return false;
        tell(ray);
        return true;
    }
    /// Hands on the ray's root.
    void tell(const OpenRay& ray) {
        std::array<std::int32_t, 3> cell{};
        std::array<double, 3> place{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            place[axis] = ray.ray.at[axis] + ray.root.depth() * ray.ray.along[axis];
            cell[axis] = std::clamp(static_cast<std::int32_t>(place[axis]), 0, last_cell_[axis]);
            place[axis] -= cell[axis];
        }
        hits_.tell(ray.pixel, ray.root, cell_slopes(grid_.numbers(cell), place));
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    TileRays rays_;
    const IndexMap& map_;
    IndexRays index_rays_;
    double error_;
    Grid grid_;
    std::array<std::int32_t, 3> last_cell_{};
    RayLines& lines_;
    VoxelHits hits_;
    Counters& counters_;
    std::uint64_t evaluations_ = 0;  ///< at cells, in double
    double finest_ = 0;              ///< as BundleSearch has it
    Pixels first_{};                 ///< of the bundle
    DepthRange inside_{};            ///< of the bundle
    LaneWalk lanes_;
    bool has_columns_ = false;
    /// The bundle's rays, a bit each: those that have not ended, that are made, and that may be at
    /// the level where the layer that was looked at last ends.
    std::uint64_t open_ = 0, begun_ = 0, unsure_ = 0;
    std::uint64_t border_ = 0;  ///< those that stay in a plane of the grid's outermost samples
    std::array<OpenRay, block_rays> bundle_;  ///< those that are made
    RayColumns columns_;
    SlabRays slab_rays_;
    double steepest_ = 0;  ///< of the bundle's slopes
    CellMask mask_;
};

}  // namespace zeroset
