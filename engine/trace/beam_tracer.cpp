// The first root on each ray by beams [Florez08, ch. 5; Knoll09; Comba93].
//   u, v       a pixel's place on the image plane at distance 1 from the eye
//   s          depth along the view axis, from the plane through the point looked at
//   cell       a square tile of pixels times a slab [s0, s1] of depth
//   form       f over a cell: c + ku eu + kv ev + kt et + [-e, e], with (eu, ev, et) in [-1, 1]^3
//              (engine/num/beam.hpp); comes with an enclosure of df/ds
// A tile of 64x64 pixels begins with slabs between its entry into the clip box and its exit. Cells
// are looked at breadth first and front to back, many at a time. The linear part of a cell's form
// contracts the slab for each quarter of the tile to where f can vanish; a quarter for which
// nothing is left is gone (Florez's rejection test). A quarter all of whose rays surely have a root
// in the slab hides its later slabs (his inclusion test). Slabs that contract badly and are long
// for their tile are halved.
// Where f is continuous and df/ds excludes 0, a tile of 8x8 pixels is solved ray by ray: the form
// gives each its stretch, Newton's method the root (beam_roots-inl.hpp). A tile of 4x4 pixels that
// is not monotone yet goes on ray by ray (beam_rays-inl.hpp).
//
// Differs from the papers:
// - A root is certified by the interval Newton operator in double: f at the guess, with a bound of
//   its rounding that comes with the form, over the enclosure of df/ds. No evaluation of the ends.
// - Nothing is rejected by the sign of a value: by enclosures, and by that operator.
// - Cells are evaluated a margin longer than their slabs, so that the bracket of a root at the end
//   of a slab is inside one cell.
// - Rays go on in double where cells in float are not decided.

#include "engine/trace/beam_tracer.hpp"

#include "engine/num/scalar.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/beam_tracer.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/beam_cells-inl.hpp"
#include "engine/trace/beam_leaf-inl.hpp"
#include "engine/trace/beam_rays-inl.hpp"
#include "engine/trace/beam_roots-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

constexpr int leaf_pixels = 8;   ///< tiles of this size are solved where f is monotone
constexpr int least_pixels = 4;  ///< smaller tiles are not made
constexpr int first_slabs = 8;

/// What a thread keeps from tile to tile.
template <class Real>
struct BeamMemory {
    Cells<Real> cells[2];
    CellRuns runs;
    CellKernels kernels;
    Found<Real> found;
};

template <class Real>
class BeamTile {
public:
    BeamTile(const TraceFrame& frame, const Tile& tile, BeamMemory<Real>& memory, TileHits& hits,
             Counters& counters)
        : frame_(frame),
          tile_(tile),
          hits_(hits),
          counters_(counters),
          view_(frame, tile),
          cells_(&memory.cells[0]),
          next_(&memory.cells[1]),
          runs_(memory.runs),
          kernels_(memory.kernels),
          found_(memory.found),
          roots_(frame, view_, found_, counters),
          leaves_(frame, tile, view_, found_, roots_, counters),
          small_leaves_(frame, tile, view_, found_, roots_, counters),
          marcher_(frame, view_, found_, roots_, counters),
          fine_marcher_(frame, view_, found_, roots_, counters) {}

    void trace();

private:
    using Place = typename Cells<Real>::Place;
    /// A quarter of the tile at work.
    struct Child {
        Place place;
        std::size_t index;
        DepthRange depths;  ///< of its rays, where some cell of the tile is not inside the clip box
    };
    static constexpr auto unit = static_cast<double>(std::numeric_limits<Real>::epsilon());

    /// The first cells; false when no ray meets the clip box.
    bool start();
    void descend(int pixels);
    void visit_run(const CellRun& run, int pixels);
    /// Cells first to last of one tile, in a run; its children go to next_.
    void visit_tile(const CellRun& run, std::size_t first, std::size_t last, int pixels);
    void push_children(const CellRun& run, int pixels);
    void push_child(const Child& tile, int pixels, std::size_t parent);
    [[nodiscard]] bool is_accurate(std::size_t cell) const;
    /// The pixels of a smooth cell.
    void solve_leaf(std::size_t cell, int pixels, const Kernel* kernel);
    /// The pixels of a cell one by one.
    void march_pixels(std::size_t cell, int pixels, const Kernel* kernel);
    void march_rays();
    void pass(std::uint32_t pixel, double s);
    void hand_on();
    void hand_on_row(int row);

    [[nodiscard]] DepthRange depths_of(int col, int row, int pixels) const {
        const bool needed =
            std::ranges::any_of(open_, [&](std::size_t cell) { return cells_->inside[cell] == 0; });
        if (!needed) return {};
        const double half = 0.5 * (pixels - 1);
        return view_.depths(view_.u(col + half), view_.v(row + half), half * view_.pixel(),
                            half * view_.pixel());
    }
    [[nodiscard]] Place place(int col, int row, int pixels, const Kernel* kernel) const {
        const double half = 0.5 * (pixels - 1);
        return {static_cast<Real>(view_.u(col + half)), static_cast<Real>(view_.v(row + half)), col,
                row, kernel};
    }
    /// How much longer than their slabs cells are: from size to size a little less, so that they
    /// lie in those that their kernels were shortened for.
    [[nodiscard]] Real margin(int pixels) const {
        return margin_ *
               static_cast<Real>(0.75 + 0.25 * std::bit_width(static_cast<unsigned>(pixels)));
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    TileHits& hits_;
    Counters& counters_;
    BeamView view_;
    Cells<Real>* cells_;
    Cells<Real>* next_;
    CellRuns& runs_;
    CellKernels& kernels_;
    Found<Real>& found_;
    RootFinder<Real> roots_;
    LeafSolver<Real, leaf_pixels> leaves_;
    LeafSolver<Real, least_pixels> small_leaves_;
    RayMarcher<Real, Real> marcher_;
    RayMarcher<double, Real> fine_marcher_;
    std::vector<std::size_t> open_;  ///< cells of the tile at work that go on to its children
    DepthRange all_{};               ///< of the tile's rays
    double s_most_ = 0;
    Real margin_ = 0;
    Real fair_guess_ = 0;
};

template <class Real>
bool BeamTile<Real>::start() {
    const double half = 0.5 * (tile_size - 1);
    const double radius = half * view_.pixel();
    all_ = view_.depths(view_.u(half), view_.v(half), radius, radius);
    if (all_.empty()) return false;
    s_most_ = std::max(std::abs(all_.enter_lo), std::abs(all_.exit_hi)) * (1.0 + 0x1p-10);
    const double finest = std::max(view_.tolerance(), 8 * s_most_ * unit);
    margin_ = static_cast<Real>(2 * finest);
    fair_guess_ = static_cast<Real>(0.005 * view_.extent());
    const Place at = place(0, 0, tile_size, &frame_.kernel);
    const Real near = -upper_end(Real{}, -all_.enter_lo);
    const Real far = upper_end(Real{}, all_.exit_hi);
    Real from = near;
    for (int i = 1; i <= first_slabs; ++i) {
        const Real part = static_cast<Real>(i) / first_slabs;
        const Real to = i == first_slabs ? far : near + (far - near) * part;
        const bool inside =
            static_cast<double>(from) >= all_.enter_hi && static_cast<double>(to) <= all_.exit_lo;
        cells_->push(at, from, to, margin(tile_size), inside);
        from = to;
    }
    return true;
}

template <class Real>
void BeamTile<Real>::trace() {
    found_.begin(hits_);
    cells_->size = 0;
    kernels_.clear();
    if (!start()) return;
    for (int pixels = tile_size; pixels >= least_pixels && cells_->size > 0; pixels /= 2) {
        next_->size = 0;
        descend(pixels);
        std::swap(cells_, next_);
    }
    roots_.solve();
    march_rays();
    hand_on();
}

template <class Real>
void BeamTile<Real>::descend(int pixels) {
    const FrustumOf<Real> frustum = view_.frustum<Real>(pixels, s_most_);
    cells_->places.pad(cells_->size);
    runs_.divide(std::span(cells_->kernel).first(cells_->size));
    for (CellRun& run : runs_.all())
        evaluate(frame_, frustum, run, cells_->places, cells_->forms, counters_);
    CellJudge<Real>(pixels).judge(*cells_);
    for (const CellRun& run : runs_.all())
        visit_run(run, pixels);
}

template <class Real>
void BeamTile<Real>::visit_run(const CellRun& run, int pixels) {
    const std::size_t end = run.first + run.count;
    for (std::size_t first = run.first; first < end;) {
        std::size_t last = first + 1;
        while (last < end && cells_->col[last] == cells_->col[first] &&
               cells_->row[last] == cells_->row[first]) {
            ++last;
        }
        visit_tile(run, first, last, pixels);
        first = last;
    }
}

template <class Real>
void BeamTile<Real>::visit_tile(const CellRun& run, std::size_t first, std::size_t last,
                                int pixels) {
    const auto kernel_of = [&](std::size_t cell) {
        return kernels_.shortened(run, std::span(&cell, 1));
    };
    open_.clear();
    for (std::size_t i = first; i < last; ++i) {
        if (cells_->bit(&CellBits::rejected, i)) continue;
        const bool smooth = cells_->bit(&CellBits::smooth, i);
        const bool finished = cells_->bit(&CellBits::finished, i);
        const bool whole = finished && open_.empty() && is_accurate(i);
        if (smooth && (pixels <= leaf_pixels || whole)) {
            solve_leaf(i, pixels, kernel_of(i));
        } else if (pixels <= least_pixels) {
            march_pixels(i, pixels, kernel_of(i));
        } else {
            open_.push_back(i);
        }
        if (finished) break;
    }
    if (!open_.empty()) push_children(run, pixels);
}

template <class Real>
void BeamTile<Real>::push_children(const CellRun& run, int pixels) {
    const int half = pixels / 2;
    const Kernel* const kernel = kernels_.shortened(run, open_);
    const std::size_t parent = open_.front();
    for (std::size_t child = 0; child < 4; ++child) {
        const int col = cells_->col[parent] + ((child & 1U) != 0 ? half : 0);
        const int row = cells_->row[parent] + ((child & 2U) != 0 ? half : 0);
        if (col >= tile_.cols || row >= tile_.rows) continue;
        const Child tile{place(col, row, half, kernel), child, depths_of(col, row, half)};
        for (const std::size_t cell : open_) {
            push_child(tile, half, cell);
            if (cells_->child_finished(child, cell)) break;
        }
    }
}

template <class Real>
void BeamTile<Real>::push_child(const Child& tile, int pixels, std::size_t parent) {
    Real from = cells_->child_from[tile.index][parent];
    Real to = cells_->child_to[tile.index][parent];
    bool inside = cells_->inside[parent] != 0;
    if (!inside) {
        from = std::max(from, -upper_end(Real{}, -tile.depths.enter_lo));
        to = std::min(to, upper_end(Real{}, tile.depths.exit_hi));
        inside = static_cast<double>(from) >= tile.depths.enter_hi &&
                 static_cast<double>(to) <= tile.depths.exit_lo;
    }
    if (!(from <= to)) return;
    const Real length = to - from;
    const Real parent_length = cells_->to[parent] - cells_->from[parent];
    const Real width = 2 * static_cast<Real>((view_.distance() + static_cast<double>(from)) *
                                             view_.pixel() * pixels);
    int parts = 1;
    if (length > width && length > static_cast<Real>(0.6) * parent_length) {
        parts = length > 3 * width && pixels >= leaf_pixels ? 4 : 2;
    }
    Real begin = from;
    for (int i = 1; i <= parts; ++i) {
        const Real end =
            i == parts ? to : from + length * (static_cast<Real>(i) / static_cast<Real>(parts));
        next_->push(tile.place, begin, end, margin(pixels), inside);
        begin = end;
    }
}

/// Whether the form tells the depth of the roots to a hundredth of the view's size, a fair guess.
template <class Real>
bool BeamTile<Real>::is_accurate(std::size_t cell) const {
    const Forms<Real>& f = cells_->forms;
    return f.e[cell] * cells_->places.s_radius[cell] < fair_guess_ * std::abs(f.k[2][cell]);
}

template <class Real>
void BeamTile<Real>::solve_leaf(std::size_t cell, int pixels, const Kernel* kernel) {
    const Forms<Real>& f = cells_->forms;
    const Real half = static_cast<Real>(0.5 * (pixels - 1));
    const Real ku = f.k[0][cell] / half;
    const Real kv = f.k[1][cell] / half;
    const Real first = f.c[cell] - f.k[0][cell] + f.k[1][cell];
    Leaf<Real> leaf{cells_->col[cell],
                    cells_->row[cell],
                    cells_->inside[cell] != 0,
                    first,
                    ku,
                    kv,
                    f.k[2][cell],
                    f.e[cell],
                    cells_->places.s[cell],
                    cells_->places.s_radius[cell],
                    cells_->from[cell],
                    cells_->to[cell],
                    -f.slope_neg_lo[cell],
                    f.slope_hi[cell],
                    f.r[cell],
                    kernel};
    if (pixels < leaf_pixels) {
        small_leaves_.solve(leaf);
        return;
    }
    for (int row = 0; row < pixels; row += leaf_pixels) {
        for (int col = 0; col < pixels; col += leaf_pixels) {
            leaf.col = cells_->col[cell] + col;
            leaf.row = cells_->row[cell] + row;
            leaf.c = first + ku * static_cast<Real>(col) - kv * static_cast<Real>(row);
            if (leaf.col < tile_.cols && leaf.row < tile_.rows) leaves_.solve(leaf);
        }
    }
}

template <class Real>
void BeamTile<Real>::march_pixels(std::size_t cell, int pixels, const Kernel* kernel) {
    const Forms<Real>& f = cells_->forms;
    const auto number = [cell](const std::vector<Real>& column) {
        return static_cast<double>(column[cell]);
    };
    const double half = 0.5 * (pixels - 1);
    const double c = number(f.c);
    const double ku = number(f.k[0]) / half;
    const double kv = number(f.k[1]) / half;
    const double kt = number(f.k[2]);
    const double e = number(f.e) + 0x1p-10 * half * (std::abs(ku) + std::abs(kv));
    const double s = number(cells_->places.s);
    const double reach = number(cells_->places.s_radius);
    const double scale = std::abs(kt) > 0 ? reach / kt : 0;
    const double radius = std::abs(kt) > 0 ? e * std::abs(scale) + 4 * view_.depth_error()
                                           : std::numeric_limits<double>::infinity();
    const double from = number(cells_->from);
    const double to = number(cells_->to);
    for (int row = 0; row < pixels && cells_->row[cell] + row < tile_.rows; ++row) {
        for (int col = 0; col < pixels && cells_->col[cell] + col < tile_.cols; ++col) {
            const double middle = s - (c + ku * (col - half) - kv * (row - half)) * scale;
            const double ray_from = std::max(from, middle - radius);
            const double ray_to = std::min(to, middle + radius);
            if (!(ray_from <= ray_to)) continue;
            const auto pixel = static_cast<std::uint32_t>((cells_->row[cell] + row) * tile_size +
                                                          cells_->col[cell] + col);
            if (ray_from > static_cast<double>(found_.depth[pixel])) continue;
            const Real begin = -upper_end(Real{}, -ray_from);
            const Real end = upper_end(Real{}, ray_to);
            marcher_.push({pixel, cells_->inside[cell] != 0, begin, end, end - begin, kernel});
        }
    }
}

template <class Real>
void BeamTile<Real>::march_rays() {
    // Cells in this type are decided down to some hundred of its units.
    const double rough = std::max(view_.tolerance(), 256 * s_most_ * unit);
    const bool final = rough <= view_.tolerance();
    const auto stop = [&](std::uint32_t pixel, double from, double to, bool continuous) {
        if (!continuous) {
            pass(pixel, from);
            return true;
        }
        found_.add_undecided(pixel, 0.5 * from + 0.5 * to);
        return false;
    };
    marcher_.march(static_cast<Real>(rough), margin_, s_most_,
                   [&](const Segment<Real>& segment, bool continuous) {
                       const auto from = static_cast<double>(segment.from);
                       const auto to = static_cast<double>(segment.to);
                       if (final) return stop(segment.pixel, from, to, continuous);
                       fine_marcher_.push(
                           {segment.pixel, segment.inside, from, to, to - from, segment.kernel});
                       return true;
                   });
    fine_marcher_.march(view_.tolerance(), 0.5 * view_.tolerance(), s_most_,
                        [&](const Segment<double>& segment, bool continuous) {
                            return stop(segment.pixel, segment.from, segment.to, continuous);
                        });
}

template <class Real>
void BeamTile<Real>::hand_on() {
    hits_.any = found_.any();
    for (int row = 0; row < tile_.rows && hits_.any; ++row)
        hand_on_row(row);
    for (const std::uint32_t pixel : found_.without_gradient) {
        if (hits_.certificate[pixel] != Certificate::Undecided) continue;
        const glm::dvec3 x = view_.point(pixel % tile_size, pixel / tile_size,
                                         static_cast<double>(found_.depth[pixel]));
        hits_.points.push_back({pixel, {x.x, x.y, x.z}});
    }
    if (!hits_.any_unsettled) return;
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
        if (hits_.unsettled[pixel] <= hits_.depth[pixel])
            hits_.certificate[pixel] = Certificate::Undecided;
    }
}

/// Depths along the view axis to distances along the rays.
template <class Real>
void BeamTile<Real>::hand_on_row(int row) {
    const double v = view_.v(row);
    const auto first = static_cast<std::size_t>(row) * tile_size;
    for (std::size_t col = 0; col < tile_size; ++col) {
        const double u = view_.u(static_cast<double>(col));
        const double stretch = std::sqrt(1.0 + u * u + v * v);
        const double s = static_cast<double>(found_.depth[first + col]);
        hits_.depth[first + col] = static_cast<float>((view_.distance() + s) * stretch);
    }
}

/// A cell on the ray of a pixel, from s on, that was not decided.
template <class Real>
void BeamTile<Real>::pass(std::uint32_t pixel, double s) {
    const double u = view_.u(pixel % tile_size);
    const double v = view_.v(pixel / tile_size);
    const double depth = (view_.distance() + s) * std::sqrt(1.0 + u * u + v * v) * (1.0 - 0x1p-20);
    hits_.pass({static_cast<std::int16_t>(pixel % tile_size),
                static_cast<std::int16_t>(pixel / tile_size)},
               -float_above(-std::max(depth, 0.0)));
}

template <class Real>
void trace_in(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters) {
    thread_local BeamMemory<Real> memory;
    BeamTile<Real>(frame, tile, memory, hits, counters).trace();
}

void trace_beam_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                     Counters& counters) {
    if (frame.precision == Precision::Double) {
        trace_in<double>(frame, tile, hits, counters);
    } else {
        trace_in<float>(frame, tile, hits, counters);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(trace_beam_tile);

void trace_tile_beams(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters) {
    HWY_DYNAMIC_DISPATCH(trace_beam_tile)(frame, tile, hits, counters);
}

}  // namespace zeroset

#endif
