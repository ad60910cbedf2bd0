// The first roots of a plain isosurface, voxel by voxel, proved.
//   index    places in the grid: sample (i, j, k) is at (i, j, k), a cell between eight of them
//   layer    the cells between two neighbouring slices of samples, across the axis k of the grid
//            that rays are nearest to
//   slab     some layers, one behind the other
// Bundles of 8 x 8 rays go through the pyramid of minima and maxima together: its bricks between
// the bundle's outermost rays are looked at slab by slab, front to back. In a slab of four layers
// that may hold the level, the cells that may are marked by a bit each, for all rays at once. Each
// ray goes through the marked cells of these layers one by one; in them f is a cubic along it, of
// which Bernstein coefficients tell all (ray_cubic.hpp).
//
// What is proved: in double, numbers are known to +-error (`GridBounds`), and places to less than
// that changes f by. A ray that slips by rounding through the edge of another cell than those it is
// looked for in is there for so short a stretch that f changes by less than `error`, so a stretch
// on which f is farther from 0 than that has no root beside it either.

#include "engine/trace/voxels/proved_voxels.hpp"

#include "engine/trace/along_rays/ray_lines.hpp"
#include "engine/trace/tile_costs.hpp"
#include "engine/trace/voxels/block_walk.hpp"
#include "engine/trace/voxels/grid_bounds.hpp"
#include "engine/trace/voxels/isosurface.hpp"
#include "engine/trace/voxels/voxel_hits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace zeroset {
namespace {

constexpr int block_size = 8;  ///< pixels along a side of a bundle

/// A ray of a bundle that has not ended.
struct OpenRay {
    std::uint32_t pixel = 0;
    IndexRays::Ray ray{};
    /// Its place across the axis k as a line in the place along it.
    double i_at = 0, i_slope = 0, j_at = 0, j_slope = 0;
    double per_layer = 0;  ///< depth from a layer to the next one up
    bool begun = false;    ///< what follows is known
    double from = 0, to = 0;
    FirstRoot root = {};
};

/// The rays of a tile in the grid of one type of samples.
template <class Sample>
class VoxelTile {
public:
    VoxelTile(const TraceFrame& frame, const Tile& tile, const Isosurface& surface,
              const Sample* samples, const GridBounds& bounds, RayLines& lines, TileHits& hits,
              Counters& counters)
        : frame_(frame),
          tile_(tile),
          rays_(frame, tile),
          map_(surface.volume->data().map()),
          index_rays_(rays_, map_),
          error_(bounds.error()),
          grid_(surface.volume->data(), samples, surface.level, error_),
          lines_(lines),
          hits_(frame, rays_, lines_, map_, hits, counters),
          counters_(counters) {
        for (std::size_t i = 0; i < 3; ++i)
            last_cell_[i] = static_cast<std::int32_t>(surface.volume->data().samples().size[i]) - 2;
        lines_.begin_singly(frame, std::numeric_limits<float>::digits);
    }

    /// False: bundles cannot go through the grid from here.
    bool run() {
        const RayBlock whole = bundle(0, 0, tile_.cols, tile_.rows, from_front());
        if (!whole.usable()) return false;
        const double from = first_depth(whole);
        if (!std::isfinite(from)) return true;
        for (int row = 0; row < tile_.rows; row += block_size) {
            for (int col = 0; col < tile_.cols; col += block_size) {
                const int cols = std::min(block_size, tile_.cols - col);
                const int rows = std::min(block_size, tile_.rows - row);
                if (frame_.stopped()) {
                    hits_.leave(col, row, cols, rows);
                } else {
                    trace_block(col, row, cols, rows, from);
                }
            }
        }
        return true;
    }

private:
    static double from_front() { return -std::numeric_limits<double>::infinity(); }

    /// The bundle of some pixels' rays, from a depth on.
    [[nodiscard]] RayBlock bundle(int col, int row, int cols, int rows, double from) const {
        const double u = rays_.u(col + 0.5 * (cols - 1));
        const double v = rays_.v(row + 0.5 * (rows - 1));
        const double u_radius = 0.5 * cols * rays_.pixel();
        const double v_radius = 0.5 * rows * rays_.pixel();
        const DepthRange depths = rays_.depths(u, v, u_radius, v_radius);
        if (depths.empty()) return RayBlock::nothing();
        return {index_rays_,
                u,
                v,
                u_radius,
                v_radius,
                std::max(from, depths.enter_lo),
                std::max(from, depths.exit_hi),
                last_cell_};
    }
    /// Where the bundle first comes to bricks that may hold the level, at most; +inf: nowhere.
    double first_depth(const RayBlock& block) {
        double depth = std::numeric_limits<double>::infinity();
        walk_block(grid_, block, [&](const CellRectangle&, const LayerRange& layers) {
            depth = block.depth_at(block.step() > 0 ? layers.low : layers.high);
            return false;
        });
        count(0, 0, tile_.cols, tile_.rows, 1);
        return depth;
    }
    void count(int col, int row, int cols, int rows, std::uint64_t looks) {
        counters_.range += looks;
        if (counters_.costs != nullptr)
            counters_.costs->add(col, row, cols, rows, static_cast<double>(looks));
    }

    void trace_block(int col, int row, int cols, int rows, double from) {
        const RayBlock block = bundle(col, row, cols, rows, from);
        if (!block.usable()) return hits_.leave(col, row, cols, rows);
        if (block.empty()) return;
        open_ = 0;
        bool made = false;
        std::uint64_t looks = 0;
        walk_block(grid_, block, [&](const CellRectangle& cells, const LayerRange& layers) {
            ++looks;
            static_assert(1 << LevelGrid<Sample>::lowest_shift == CellMask::most_layers);
            const bool fits = cells.i_last - cells.i_first < CellMask::most_cells - 1 &&
                              cells.j_last - cells.j_first < CellMask::most_cells - 1;
            if (fits) grid_.find(cells, layers, block.axes(), mask_);
            if (fits && !mask_.any) return true;
            if (!made) make_rays(col, row, cols, rows, block);
            made = true;
            walk_slab(fits ? &mask_ : nullptr, layers, block);
            return open_ != 0;
        });
        count(col, row, cols, rows, looks);
        for_each_bit(open_, [&](std::size_t ray) {
            if (bundle_[ray].begun && bundle_[ray].root.finish()) tell(bundle_[ray]);
        });
    }
    template <class Take>
    static void for_each_bit(std::uint64_t bits, const Take& take) {
        for (; bits != 0; bits &= bits - 1)
            take(static_cast<std::size_t>(std::countr_zero(bits)));
    }
    /// Makes all rays of a bundle, as a ray and as columns.
    void make_rays(int col, int row, int cols, int rows, const RayBlock& block) {
        open_ = 0;
        steepest_ = 0;
        const std::int32_t first = block.first_layer();
        const CellRectangle cells = block.cells(first, first);
        i_shared_ = cells.i_first;
        j_shared_ = cells.j_first;
        first_layer_ = first;
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < cols; ++x) {
                const auto at = static_cast<std::size_t>(y * block_size + x);
                const OpenRay& ray = bundle_[at] = ray_at(col + x, row + y, block.axes());
                open_ |= std::uint64_t{1} << at;
                steepest_ = std::max({steepest_, std::abs(ray.i_slope), std::abs(ray.j_slope)});
                columns_.i_at[at] = static_cast<float>(ray.i_at + ray.i_slope * first - i_shared_);
                columns_.j_at[at] = static_cast<float>(ray.j_at + ray.j_slope * first - j_shared_);
                columns_.i_slope[at] = static_cast<float>(ray.i_slope);
                columns_.j_slope[at] = static_cast<float>(ray.j_slope);
            }
        }
    }
    [[nodiscard]] OpenRay ray_at(int col, int row, const WalkAxes& axes) const {
        OpenRay ray{.pixel = static_cast<std::uint32_t>(row * tile_size + col),
                    .ray = index_rays_.ray(rays_.u(col), rays_.v(row))};
        ray.per_layer = 1 / ray.ray.along[axes.k];
        ray.i_slope = ray.ray.along[axes.i] * ray.per_layer;
        ray.j_slope = ray.ray.along[axes.j] * ray.per_layer;
        ray.i_at = ray.ray.at[axes.i] - ray.i_slope * ray.ray.at[axes.k];
        ray.j_at = ray.ray.at[axes.j] - ray.j_slope * ray.ray.at[axes.k];
        return ray;
    }
    /// Takes the open rays through the layers of a slab.
    void walk_slab(const CellMask* mask, const LayerRange& layers, const RayBlock& block) {
        const int step = block.step();
        for (std::int32_t layer = step > 0 ? layers.low : layers.high;
             layer >= layers.low && layer <= layers.high && open_ != 0; layer += step) {
            if (mask != nullptr &&
                !mask->layer_any[static_cast<std::size_t>(layer - mask->layers.low)])
                continue;
            for_each_bit(open_ & near(mask, layer), [&](std::size_t at) {
                OpenRay& ray = bundle_[at];
                if (mask != nullptr && !may_hold(*mask, ray, layer)) return;
                if (!begin(ray) || walk_layer(ray, mask, layer, block.axes()))
                    open_ &= ~(std::uint64_t{1} << at);
            });
        }
    }
    /// The rays that may be in marked cells of a layer.
    [[nodiscard]] std::uint64_t near(const CellMask* mask, std::int32_t layer) const {
        constexpr double most_layers = 512;  ///< that float is fine enough for
        const double layers = layer - first_layer_;
        if (mask == nullptr || !mask->is_small() || steepest_ > 1.5 ||
            std::abs(layers) > most_layers)
            return ~std::uint64_t{0};
        NearCells cells = mask->near(layer);
        cells.layer = static_cast<float>(layers);
        cells.i_first = static_cast<float>(mask->cells.i_first - i_shared_);
        cells.j_first = static_cast<float>(mask->cells.j_first - j_shared_);
        return rays_near(columns_, cells);
    }
    /// Finds where the ray is in the region when it first comes near the surface; false: nowhere.
    bool begin(OpenRay& ray) {
        if (ray.begun) return true;
        const auto col = static_cast<int>(ray.pixel % tile_size);
        const auto row = static_cast<int>(ray.pixel / tile_size);
        if (!lines_.take(tile_, rays_, col, row)) return false;
        const RayLine& line = lines_.of(ray.pixel);
        ray.begun = true;
        ray.from = line.from;
        ray.to = line.to;
        ray.root = FirstRoot(error_, lines_.finest(line, line.from));
        return true;
    }

    /// Whether the level may be in a cell of a layer that the ray is in.
    static bool may_hold(const CellMask& mask, const OpenRay& ray, std::int32_t layer) {
        const double i = ray.i_at + ray.i_slope * layer;
        const double j = ray.j_at + ray.j_slope * layer;
        const double beyond_i = i + ray.i_slope;
        const double beyond_j = j + ray.j_slope;
        return mask.may_hold_between(std::min(i, beyond_i), std::max(i, beyond_i),
                                     std::min(j, beyond_j), std::max(j, beyond_j), layer);
    }
    struct Stretch {
        double from, to;
    };
    /// The stretch of the ray in a layer, as far as it is looked for roots.
    static Stretch stretch_in(const OpenRay& ray, std::int32_t layer, std::size_t axis) {
        const auto [from, to] = std::minmax({(layer - ray.ray.at[axis]) * ray.per_layer,
                                             (layer + 1 - ray.ray.at[axis]) * ray.per_layer});
        return {.from = std::max(from, ray.from), .to = std::min(to, ray.to)};
    }
    /// Takes the ray through the cells of a layer; whether it has ended.
    bool walk_layer(OpenRay& ray, const CellMask* mask, std::int32_t layer, const WalkAxes& axes) {
        const auto& at = ray.ray.at;
        const auto& along = ray.ray.along;
        const Stretch whole = stretch_in(ray, layer, axes.k);
        if (!(whole.from <= whole.to)) return whole.from >= ray.to && end(ray);
        double from = whole.from;
        const auto cell_of = [&](std::size_t axis, double s) {
            return static_cast<std::int32_t>(std::floor(at[axis] + s * along[axis]));
        };
        std::int32_t i = cell_of(axes.i, from);
        std::int32_t j = cell_of(axes.j, from);
        const auto look_in = [&](const Stretch& stretch) {
            const bool inside =
                i >= 0 && i <= last_cell_[axes.i] && j >= 0 && j <= last_cell_[axes.j];
            return inside && (mask == nullptr || mask->may_hold(i, j, layer)) &&
                   look(ray, cell_at(i, j, layer, axes), stretch);
        };
        if (i == cell_of(axes.i, whole.to) && j == cell_of(axes.j, whole.to)) return look_in(whole);
        const int step_i = along[axes.i] > 0 ? 1 : -1;
        const int step_j = along[axes.j] > 0 ? 1 : -1;
        const auto leaves = [&](std::size_t axis, std::int32_t cell, int step) {
            if (along[axis] == 0) return std::numeric_limits<double>::infinity();
            return (cell + (step > 0 ? 1 : 0) - at[axis]) / along[axis];
        };
        double leaves_i = leaves(axes.i, i, step_i);
        double leaves_j = leaves(axes.j, j, step_j);
        for (;;) {
            const double to = std::max(from, std::min({whole.to, leaves_i, leaves_j}));
            if (look_in({.from = from, .to = to})) return true;
            if (!(to < whole.to)) return false;
            from = to;
            if (leaves_i <= leaves_j) {
                i += step_i;
                leaves_i = leaves(axes.i, i, step_i);
            } else {
                j += step_j;
                leaves_j = leaves(axes.j, j, step_j);
            }
        }
    }
    static std::array<std::int32_t, 3> cell_at(std::int32_t i, std::int32_t j, std::int32_t layer,
                                               const WalkAxes& axes) {
        std::array<std::int32_t, 3> cell{};
        cell[axes.i] = i;
        cell[axes.j] = j;
        cell[axes.k] = layer;
        return cell;
    }
    /// Ends a ray that has left the region.
    bool end(OpenRay& ray) {
        if (ray.root.finish()) tell(ray);
        return true;
    }
    /// Looks at the ray in a cell; whether it has ended.
    bool look(OpenRay& ray, const std::array<std::int32_t, 3>& cell, const Stretch& stretch) {
        const auto place = [&](double s) {
            std::array<double, 3> in_cell{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                in_cell[axis] = ray.ray.at[axis] + s * ray.ray.along[axis] - cell[axis];
            return in_cell;
        };
        ++counters_.value;
        if (counters_.costs != nullptr) counters_.costs->add(ray.pixel);
        const RayCubic cubic = ray_cubic(grid_.corners(cell), place(stretch.from),
                                         place(stretch.to), stretch.from, stretch.to);
        if (!ray.root.look(cubic)) return false;
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
        hits_.tell(ray.pixel, ray.root, cell_slopes(grid_.corners(cell), place));
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    TileRays rays_;
    const IndexMap& map_;
    IndexRays index_rays_;
    double error_;
    LevelGrid<Sample> grid_;
    std::array<std::int32_t, 3> last_cell_{};
    RayLines& lines_;
    VoxelHits hits_;
    Counters& counters_;
    std::array<OpenRay, block_rays> bundle_;
    std::uint64_t open_ = 0;  ///< the rays of the bundle that have not ended, a bit each
    RayColumns columns_;
    std::int32_t i_shared_ = 0, j_shared_ = 0, first_layer_ = 0;  ///< where columns_ count from
    double steepest_ = 0;                                         ///< of the bundle's slopes
    CellMask mask_;
};

/// Samples that float holds.
template <class Sample>
constexpr bool fits_float =
    std::is_same_v<Sample, float> || (std::is_integral_v<Sample> && sizeof(Sample) <= 2);

}  // namespace

bool trace_tile_proved_voxels(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                              Counters& counters) {
    const bool plain = frame.precision == Precision::Float && !frame.whole_pixels &&
                       tile.places == nullptr && frame.union_members.empty();
    if (!plain) return false;
    const auto surface = isosurface(frame.kernel, frame.scene);
    if (!surface || surface->volume->data().range().holes) return false;
    const GridBounds bounds(*surface, frame);
    if (!bounds.usable()) return false;
    return visit_samples(surface->volume->data().samples(), [&](const auto* samples) {
        using Sample = std::remove_cvref_t<decltype(*samples)>;
        if constexpr (fits_float<Sample>) {
            thread_local RayLines lines;
            return VoxelTile<Sample>(frame, tile, *surface, samples, bounds, lines, hits, counters)
                .run();
        } else {
            return false;
        }
    });
}

}  // namespace zeroset
