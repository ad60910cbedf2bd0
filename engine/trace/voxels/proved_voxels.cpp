// The first roots of a plain isosurface, voxel by voxel, proved.
//   index    places in the grid: sample (i, j, k) is at (i, j, k), a cell between eight of them
//   layer    the cells between two neighbouring slices of samples, across the axis k of the grid
//            that rays are nearest to
//   slab     some layers, one behind the other
// Bundles of 8 x 8 rays go through the pyramid of minima and maxima together [as Knoll's packets
// do, Knoll09b]: its bricks between the bundle's outermost rays are looked at slab by slab, front
// to back. In a slab of four layers that may hold the level, the cells that may are marked by a bit
// each, for all rays at once. Each ray goes through the cells of these layers one by one; in one
// that is marked f is a cubic along it, of which Bernstein coefficients tell all (ray_cubic.hpp).
//
// What is proved: in double, numbers are known to +-error (`error_of`), and places to less than
// that changes f by. A ray that slips by rounding through the edge of another cell than those it is
// looked for in is there for so short a stretch that f changes by less than `error`, so a stretch
// on which f is farther from 0 than that has no root beside it either.

#include "engine/trace/voxels/proved_voxels.hpp"

#include "engine/trace/along_rays/hit_writer.hpp"
#include "engine/trace/along_rays/ray_lines.hpp"
#include "engine/trace/tile_costs.hpp"
#include "engine/trace/voxels/block_walk.hpp"
#include "engine/trace/voxels/isosurface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace zeroset {
namespace {

constexpr int block_size = 8;  ///< pixels along a side of a bundle

/// A ray of a bundle that has not ended.
struct OpenRay {
    std::uint32_t pixel = 0;
    bool begun = false;
    IndexRays::Ray ray{};
    double from = 0, to = 0;
    FirstRoot root = {};
};

/// Bounds of the numbers of a volume and a level.
struct GridBounds {
    double size;     ///< of samples and level
    double indices;  ///< of all terms of places in the grid

    GridBounds(const Isosurface& surface, const TraceFrame& frame)
        : size(std::abs(surface.level)), indices(0) {
        const VolumeData& data = surface.volume->data();
        size += std::max(std::abs(data.range().lo), std::abs(data.range().hi));
        const Box& clip = frame.scene.clip;
        const glm::dvec3 eye = glm::abs(frame.view.eye);
        const glm::dvec3 box = glm::max(glm::abs(clip.lo), glm::abs(clip.hi));
        const double reach = std::max({eye.x, eye.y, eye.z}) + std::max({box.x, box.y, box.z}) +
                             frame.view.look_distance;
        for (std::size_t i = 0; i < 3; ++i) {
            double sum = std::abs(data.map().shift[i]);
            for (const double entry : data.map().index_from_world[i])
                sum += 4 * std::abs(entry) * reach;
            indices = std::max({indices, sum, static_cast<double>(data.samples().size[i])});
        }
    }
    /// What rounding may make of f: of places, some ulp of their terms times f's steepest slope;
    /// of sums of samples, some ulp of these.
    [[nodiscard]] double error() const { return 0x1p-46 * (indices + 16) * size; }
    /// Whether places are known well enough.
    [[nodiscard]] bool usable() const { return indices < 0x1p30 && std::isfinite(size); }
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
          index_rays_(rays_, surface.volume->data().map()),
          error_(bounds.error()),
          grid_(surface.volume->data(), samples, surface.level, error_),
          hits_(hits),
          lines_(lines),
          writer_(rays_, lines_, hits),
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
                    leave_block(col, row, cols, rows);
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
    RayBlock bundle(int col, int row, int cols, int rows, double from) const {
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
        if (!block.usable()) return leave_block(col, row, cols, rows);
        if (block.empty()) return;
        open_.clear();
        for (int y = row; y < row + rows; ++y) {
            for (int x = col; x < col + cols; ++x)
                open_.push_back({.pixel = static_cast<std::uint32_t>(y * tile_size + x)});
        }
        std::uint64_t looks = 0;
        walk_block(grid_, block, [&](const CellRectangle& cells, const LayerRange& layers) {
            ++looks;
            const bool fits = cells.i_last - cells.i_first < CellMask::most_cells - 1 &&
                              cells.j_last - cells.j_first < CellMask::most_cells - 1;
            const CellMask* mask = nullptr;
            if (fits) {
                grid_.find(cells, layers, block.axes(), mask_);
                if (!mask_.any) return true;
                mask = &mask_;
            }
            std::erase_if(open_, [&](OpenRay& ray) {
                return !begin(ray) || walk(ray, mask, layers, block);
            });
            return !open_.empty();
        });
        count(col, row, cols, rows, looks);
        for (OpenRay& ray : open_) {
            if (ray.begun && ray.root.finish()) tell(ray);
        }
    }
    /// Makes the ray when it first comes near the surface; false: it is nowhere in the region.
    bool begin(OpenRay& ray) {
        if (ray.begun) return true;
        const auto col = static_cast<int>(ray.pixel % tile_size);
        const auto row = static_cast<int>(ray.pixel / tile_size);
        if (!lines_.take(tile_, rays_, col, row)) return false;
        const RayLine& line = lines_.of(ray.pixel);
        ray.begun = true;
        ray.ray = index_rays_.ray(rays_.u(col), rays_.v(row));
        ray.from = line.from;
        ray.to = line.to;
        ray.root = FirstRoot(error_, lines_.finest(line, line.from));
        return true;
    }

    /// Takes the ray through the layers of a slab; whether it has ended.
    bool walk(OpenRay& ray, const CellMask* mask, const LayerRange& layers, const RayBlock& block) {
        const WalkAxes& axes = block.axes();
        const double along = ray.ray.along[axes.k];
        const double per_layer = 1 / along;
        const int step = block.step();
        const auto depth_of = [&](std::int32_t slice) {
            return (slice - ray.ray.at[axes.k]) * per_layer;
        };
        std::int32_t layer = step > 0 ? layers.low : layers.high;
        double next = depth_of(step > 0 ? layer : layer + 1);
        for (; layer >= layers.low && layer <= layers.high; layer += step) {
            const double from = next;
            next = depth_of(step > 0 ? layer + 1 : layer);
            if (from >= ray.to) break;
            if (next <= ray.from ||
                (mask != nullptr && !mask->layer_any[static_cast<std::size_t>(layer - layers.low)]))
                continue;
            if (walk_layer(ray, mask, layer, axes,
                           {.from = std::max(from, ray.from), .to = std::min(next, ray.to)}))
                return true;
        }
        if (next < ray.to) return false;
        if (ray.root.finish()) tell(ray);
        return true;
    }
    struct Stretch {
        double from, to;
    };
    /// Takes the ray through the cells of a layer; whether it has ended.
    bool walk_layer(OpenRay& ray, const CellMask* mask, std::int32_t layer, const WalkAxes& axes,
                    const Stretch& whole) {
        const auto& at = ray.ray.at;
        const auto& along = ray.ray.along;
        double from = whole.from;
        auto i = static_cast<std::int32_t>(std::floor(at[axes.i] + from * along[axes.i]));
        auto j = static_cast<std::int32_t>(std::floor(at[axes.j] + from * along[axes.j]));
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
            const bool inside = i >= 0 && i <= last_cell_[axes.i] && j >= 0 &&
                                j <= last_cell_[axes.j];
            if (inside && (mask == nullptr || mask->may_hold(i, j, layer)) &&
                look(ray, cell_at(i, j, layer, axes), {.from = from, .to = to}))
                return true;
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
    /// Hands on the ray's root. It is certified if it is inside the region, too.
    void tell(const OpenRay& ray) {
        const FirstRoot& root = ray.root;
        const DepthRange& inside = lines_.of(ray.pixel).inside;
        const bool proved = root.is_proved() && root.from() >= inside.enter_hi &&
                            root.to() <= inside.exit_lo;
        writer_.push(ray.pixel, root.depth(), proved);
    }
    void leave_block(int col, int row, int cols, int rows) {
        for (int y = row; y < row + rows; ++y) {
            for (int x = col; x < col + cols; ++x) {
                const TileHits::Pixel at{.col = static_cast<std::int16_t>(x),
                                         .row = static_cast<std::int16_t>(y)};
                hits_.certificate[at.index()] = Certificate::Undecided;
                hits_.mark_unsettled(at, 0.0F);
            }
        }
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    TileRays rays_;
    IndexRays index_rays_;
    double error_;
    LevelGrid<Sample> grid_;
    std::array<std::int32_t, 3> last_cell_{};
    TileHits& hits_;
    RayLines& lines_;
    HitWriter writer_;
    Counters& counters_;
    std::vector<OpenRay> open_;
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
    if (!plain || no_isosurface(frame.kernel) != nullptr) return false;
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
