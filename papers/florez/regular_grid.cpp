// A regular grid walked by beams [Florez08, sec. 6.2].
//   V         a cell, [Vx, Vy, Vz]          X, Y, Z   where a beam is in a row of cells
//   Tx, Tz    (Vx - x0) / (Xa - x0), ...: where on its rays a beam may be between V's planes
//   TV        where it may be in V, the meet of Tx, Ty and Tz
// The grid knows the cells in which F does not exclude 0 (cell_grid.cpp). A beam goes row by row
// along the axis of which its rays' directions have most; of each row it looks at the cells that
// X, Y or Z cover, and its rays are searched in the TV of those that the surface may cross.
// CSG is of point sets (section 6.3): min and max of formulas, whose F is tested in each
// subdivision of T; the other way, by roots of the parts, is csg-by-roots. n-surfaces (section
// 6.4): a grid for w and parameters in intervals serves all frames in these, and so does a beam's
// way through it while the view stays.
//
// Differs from the thesis:
// - A beam is that of 8 x 8 pixels, and its rays are searched one by one, by MRFro: the thesis goes
//   on by beams.
// - The TV of a row's cells are put together, and those of rows that overlap.
// - A surface has a grid of its own; rays of the next one end at what was found before.
// - The beam's numbers are rounded outward; one that no axis leads is searched whole.

#include "engine/num/interval.hpp"
#include "papers/along_rays/mrfro.hpp"
#include "papers/along_rays/ray_search.hpp"
#include "papers/florez/cell_grid.hpp"
#include "papers/florez/florez_tracers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr int beam_side = 8;
constexpr int side = CellGrid::side;
using Real3 = std::array<Interval<double>, 3>;

Interval<double> around(double middle, double radius) {
    return {.neg_lo = radius - middle, .hi = radius + middle};
}
Interval<double> meet(const Interval<double>& a, const Interval<double>& b) {
    return {.neg_lo = std::min(a.neg_lo, b.neg_lo), .hi = std::min(a.hi, b.hi)};
}
Interval<double> hull(const Interval<double>& a, const Interval<double>& b) {
    return {.neg_lo = std::max(a.neg_lo, b.neg_lo), .hi = std::max(a.hi, b.hi)};
}
bool is_empty(const Interval<double>& a) { return a.neg_lo + a.hi < 0.0; }
constexpr Interval<double> nothing{.neg_lo = -infinity, .hi = -infinity};

/// The cells of an axis that an interval covers.
struct CellSpan {
    int from, to;
};

/// A beam's way through the grid. In upward rounding.
class GridWalk {
public:
    GridWalk(const CellGrid& grid, const TileRays& rays) : grid_(grid), rays_(rays) {}

    /// The stretches in which the rays of some pixels may be in crossed cells, front to back.
    const std::vector<Stretch>& walk(int col, int row, int cols, int rows) {
        stretches_.clear();
        aim(col, row, cols, rows);
        const auto k = static_cast<std::size_t>(axis_);
        if (!excludes_zero(direction_[k])) {
            stretches_.push_back({.from = -infinity, .to = infinity});
            return stretches_;
        }
        const bool rises = direction_[k].neg_lo < 0.0;
        for (int i = 0; i < side; ++i)
            take_row(rises ? i : side - 1 - i);
        return stretches_;
    }

private:
    void aim(int col, int row, int cols, int rows) {
        const double u = rays_.u(col + TileRays::middle_of(cols));
        const double v = rays_.v(row + TileRays::middle_of(rows));
        const double u_radius = TileRays::middle_of(cols) * rays_.pixel();
        const double v_radius = TileRays::middle_of(rows) * rays_.pixel();
        const ViewFrame& axes = rays_.axes();
        double most = -1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double across = u * axes.right[axis] + v * axes.up[axis];
            const double aside =
                u_radius * std::abs(axes.right[axis]) + v_radius * std::abs(axes.up[axis]);
            const auto k = static_cast<std::size_t>(axis);
            const double spare = 0x1p-48 * (1.0 + std::abs(across) + aside);
            direction_[k] = around(axes.forward[axis] + across, aside + spare);
            origin_[k] = around(rays_.base()[axis] + rays_.distance() * across,
                                rays_.distance() * aside + rays_.depth_error());
            const double size = std::abs(axes.forward[axis] + across);
            if (size <= most) continue;
            most = size;
            axis_ = axis;
        }
    }
    /// A cell's part of an axis, a little wider than it is.
    [[nodiscard]] Interval<double> cell(int axis, int i) const {
        const double spare = rays_.depth_error();
        return {.neg_lo = spare - grid_.plane(axis, i), .hi = spare + grid_.plane(axis, i + 1)};
    }
    /// T of an axis.
    [[nodiscard]] Interval<double> depths(int axis, int i) const {
        const auto k = static_cast<std::size_t>(axis);
        if (!excludes_zero(direction_[k])) return whole_line(0.0);
        return (cell(axis, i) - origin_[k]) / direction_[k];
    }
    [[nodiscard]] CellSpan covered(int axis, const Interval<double>& t) const {
        const auto k = static_cast<std::size_t>(axis);
        const Interval<double> x = origin_[k] + t * direction_[k];
        const double lo = grid_.plane(axis, 0);
        const double per_cell = side / (grid_.plane(axis, side) - lo);
        const auto at = [&](double place) {
            return static_cast<int>(std::clamp(std::floor(place), -1.0, double{side}));
        };
        constexpr double spare = 0x1p-20;  // of a cell
        return {.from = std::max(at((-x.neg_lo - lo) * per_cell - spare), 0),
                .to = std::min(at((x.hi - lo) * per_cell + spare), side - 1)};
    }
    void take_row(int i) {
        const Interval<double> t = depths(axis_, i);
        const int second = (axis_ + 1) % 3;
        const int third = (axis_ + 2) % 3;
        const CellSpan across = covered(second, t);
        const CellSpan along = covered(third, t);
        Interval<double> found = nothing;
        std::array<int, 3> at{};
        at[static_cast<std::size_t>(axis_)] = i;
        for (int a = across.from; a <= across.to; ++a) {
            const Interval<double> row = meet(t, depths(second, a));
            if (is_empty(row)) continue;
            at[static_cast<std::size_t>(second)] = a;
            for (int b = along.from; b <= along.to; ++b) {
                at[static_cast<std::size_t>(third)] = b;
                if (!grid_.is_crossed(at[0], at[1], at[2])) continue;
                const Interval<double> in_cell = meet(row, depths(third, b));
                if (!is_empty(in_cell)) found = hull(found, in_cell);
            }
        }
        if (!is_empty(found)) add({.from = -found.neg_lo, .to = found.hi});
    }
    /// Puts a row's stretch together with those of the rows before that are not surely in front of
    /// it: a wide beam may be in a row's crossed cells later than in those of the next row.
    void add(Stretch found) {
        while (!stretches_.empty() && found.from <= stretches_.back().to) {
            found.from = std::min(found.from, stretches_.back().from);
            found.to = std::max(found.to, stretches_.back().to);
            stretches_.pop_back();
        }
        stretches_.push_back(found);
    }

    const CellGrid& grid_;
    const TileRays& rays_;
    Real3 origin_{}, direction_{};
    int axis_ = 0;
    std::vector<Stretch> stretches_;
};

/// The stretches of the beams of a tile.
class TileStretches {
public:
    TileStretches(const CellGrid& grid, const TileRays& rays, const Tile& tile) {
        GridWalk walk(grid, rays);
        for (int row = 0; row < tile.rows; row += beam_side) {
            for (int col = 0; col < tile.cols; col += beam_side)
                of_beam_[beam_at(col, row)] =
                    walk.walk(col, row, std::min(beam_side, tile.cols - col),
                              std::min(beam_side, tile.rows - row));
        }
    }
    [[nodiscard]] const std::vector<Stretch>& of(std::uint32_t pixel) const {
        return of_beam_[beam_at(static_cast<int>(pixel) % tile_size,
                                static_cast<int>(pixel) / tile_size)];
    }

private:
    static constexpr int beams = tile_size / beam_side;  ///< along an edge
    static std::size_t beam_at(int col, int row) {
        return static_cast<std::size_t>(row / beam_side * beams + col / beam_side);
    }
    std::array<std::vector<Stretch>, std::size_t{beams} * beams> of_beam_;
};

/// The walks of beams through a grid that serves n frames, for all of them while the view stays
/// (CellGrid::memory). Any thread.
class WalkMemory {
public:
    std::shared_ptr<const TileStretches> find(const TraceFrame& frame, const Tile& tile) {
        const std::scoped_lock lock(mutex_);
        if (!is_of(frame)) return nullptr;
        const auto found = tiles_.find({tile.col, tile.row});
        return found == tiles_.end() ? nullptr : found->second;
    }
    void keep(const TraceFrame& frame, const Tile& tile,
              std::shared_ptr<const TileStretches> stretches) {
        const std::scoped_lock lock(mutex_);
        if (!is_of(frame)) tiles_.clear();
        view_ = frame.view;
        image_ = frame.image;
        tiles_[{tile.col, tile.row}] = std::move(stretches);
    }

private:
    [[nodiscard]] bool is_of(const TraceFrame& frame) const {
        return view_ && is_same(*view_, frame.view) && image_ == frame.image;
    }
    static bool is_same(const ViewFrame& a, const ViewFrame& b) {
        return a.eye == b.eye && a.right == b.right && a.up == b.up && a.forward == b.forward &&
               a.look_distance == b.look_distance && a.half_height == b.half_height &&
               a.projection == b.projection;
    }
    std::mutex mutex_;
    std::optional<ViewFrame> view_;
    ImageSize image_;
    std::map<std::pair<int, int>, std::shared_ptr<const TileStretches>> tiles_;
};

/// The way of a tile's beams through the grid: of a frame before, if the grid serves both.
std::shared_ptr<const TileStretches> walked(const CellGrid& grid, const TraceFrame& frame,
                                            const TileRays& rays, const Tile& tile) {
    if (!grid.of_frames()) return std::make_shared<const TileStretches>(grid, rays, tile);
    const auto memory = grid.memory().of<WalkMemory>();
    if (auto found = memory->find(frame, tile)) return found;
    auto stretches = std::make_shared<const TileStretches>(grid, rays, tile);
    memory->keep(frame, tile, stretches);
    return stretches;
}

}  // namespace

void trace_tile_regular_grid(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters) {
    if (frame.prepared == nullptr) return hits.leave_undecided(tile);
    in_precision(frame, [&](auto real) {
        using Real = decltype(real);
        thread_local const auto kept = std::make_unique<RayMemory<Real>>();
        RayMemory<Real>& memory = *kept;
        const TileRays rays(frame, tile);
        const auto stretches =
            walked(static_cast<const CellGrid&>(*frame.prepared), frame, rays, tile);
        memory.field.begin(frame, tile, rays, counters);
        MrfRo<Real> method(memory.field);
        RaySearch<Real, MrfRo<Real>>(rays, hits, memory, method)
            .run_from([&](std::uint32_t pixel, const RayLine& line, const auto& push) {
                const std::vector<Stretch>& all = stretches->of(pixel);
                for (std::size_t i = all.size(); i > 0; --i) {
                    const Stretch part{.from = std::max(all[i - 1].from, line.from),
                                       .to = std::min(all[i - 1].to, line.to)};
                    if (part.from <= part.to) push(part);
                }
            });
    });
}

}  // namespace zeroset
