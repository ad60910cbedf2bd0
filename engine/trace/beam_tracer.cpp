// The first root on each ray by beams [Florez08, ch. 5; Knoll09; ComSto93].
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
// Where f is continuous and df/ds excludes 0, the rays of a tile of 8x8 pixels are solved together,
// those of neighbouring slabs, too: the forms give each its stretch, Newton's method the root
// (beam_leaf-inl.hpp; what that leaves open, beam_roots-inl.hpp). A tile of 4x4 pixels that is not
// monotone yet goes on ray by ray (beam_rays-inl.hpp).
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
#include "engine/trace/beam_tree-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// What a thread keeps from tile to tile.
template <class Real>
struct BeamMemory {
    TreeMemory<Real> tree;
    Found<Real> found;
    MarchMemory<Real> rays;
    MarchMemory<double> fine_rays;
};

template <class Real>
class BeamTile {
public:
    BeamTile(const TraceFrame& frame, const Tile& tile, BeamMemory<Real>& memory, TileHits& hits,
             Counters& counters)
        : tile_(tile),
          hits_(hits),
          view_(frame, tile),
          tree_(frame, tile, view_, memory.tree, counters),
          found_(memory.found),
          roots_(frame, view_, found_, counters),
          leaves_(frame, tile, view_, found_, roots_, counters),
          small_leaves_(frame, tile, view_, found_, roots_, counters),
          marcher_(frame, view_, memory.rays, found_, roots_, counters),
          fine_marcher_(frame, view_, memory.fine_rays, found_, roots_, counters),
          fair_guess_(static_cast<Real>(0.005 * view_.extent())) {}

    void trace();

private:
    static constexpr auto unit = static_cast<double>(std::numeric_limits<Real>::epsilon());

    /// Cells of one size; their children are made.
    void descend(int pixels);
    /// Those of a run.
    void visit_run(const CellRun& run, int pixels);
    /// Those of one tile, first to last.
    void visit_tile(const CellRun& run, std::size_t first, std::size_t last, int pixels);
    [[nodiscard]] bool is_accurate(std::size_t cell) const;
    /// The pixels of a smooth cell.
    void solve_leaf(std::size_t cell, int pixels, const Kernel* kernel);
    /// The pixels of a cell one by one.
    void march_pixels(std::size_t cell, int pixels, const Kernel* kernel);
    void march_rays();
    void pass(std::uint32_t pixel, double s);
    void hand_on();
    void hand_on_row(int row);

    const Tile& tile_;
    TileHits& hits_;
    BeamView view_;
    CellTree<Real> tree_;
    Found<Real>& found_;
    RootFinder<Real> roots_;
    LeafSolver<Real, leaf_pixels> leaves_;
    LeafSolver<Real, least_pixels> small_leaves_;
    RayMarcher<Real, Real> marcher_;
    RayMarcher<double, Real> fine_marcher_;
    Real fair_guess_;
    std::vector<std::size_t> open_;  ///< cells of the tile at work that go on to its children
};

template <class Real>
void BeamTile<Real>::trace() {
    found_.begin(hits_, tile_, view_);
    if (tree_.cells().size == 0) return;
    for (int pixels = tile_size; pixels >= least_pixels && tree_.cells().size > 0; pixels /= 2) {
        descend(pixels);
        tree_.go_down();
    }
    roots_.solve();
    for (const Stretch& stretch : roots_.take_open()) {
        const Real from = -upper_end(Real{}, -stretch.from);
        const Real to = upper_end(Real{}, stretch.to);
        marcher_.push({stretch.pixel, stretch.inside, from, to, to - from, stretch.kernel});
    }
    march_rays();
    found_.end();
    hand_on();
}

template <class Real>
void BeamTile<Real>::descend(int pixels) {
    for (const CellRun& run : tree_.judge(pixels))
        visit_run(run, pixels);
}

template <class Real>
void BeamTile<Real>::visit_run(const CellRun& run, int pixels) {
    const Cells<Real>& cells = tree_.cells();
    const std::size_t end = run.first + run.count;
    for (std::size_t first = run.first; first < end;) {
        std::size_t last = first + 1;
        while (last < end && cells.col[last] == cells.col[first] &&
               cells.row[last] == cells.row[first]) {
            ++last;
        }
        visit_tile(run, first, last, pixels);
        first = last;
    }
}

template <class Real>
void BeamTile<Real>::visit_tile(const CellRun& run, std::size_t first, std::size_t last,
                                int pixels) {
    const Cells<Real>& cells = tree_.cells();
    open_.clear();
    for (std::size_t i = first; i < last; ++i) {
        if (cells.bit(&CellBits::rejected, i) || tree_.is_hidden(i, pixels)) continue;
        const bool smooth = cells.bit(&CellBits::smooth, i);
        const bool finished = cells.bit(&CellBits::finished, i);
        const bool whole = finished && open_.empty() && is_accurate(i);
        if (smooth && (pixels <= leaf_pixels || whole)) {
            solve_leaf(i, pixels, tree_.kernel_of(run, i));
        } else if (pixels <= least_pixels) {
            march_pixels(i, pixels, tree_.kernel_of(run, i));
        } else {
            open_.push_back(i);
        }
        if (!finished) continue;
        tree_.hide_behind(i, pixels);
        break;
    }
    leaves_.solve();
    small_leaves_.solve();
    if (!open_.empty()) tree_.push_children(run, open_, pixels);
}

/// Whether the form tells the depth of the roots to a hundredth of the view's size, a fair guess.
template <class Real>
bool BeamTile<Real>::is_accurate(std::size_t cell) const {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    return f.e[cell] * cells.places.s_radius[cell] < fair_guess_ * std::abs(f.k[2][cell]);
}

template <class Real>
void BeamTile<Real>::solve_leaf(std::size_t cell, int pixels, const Kernel* kernel) {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    const Real half = static_cast<Real>(0.5 * (pixels - 1));
    const Real ku = f.k[0][cell] / half;
    const Real kv = f.k[1][cell] / half;
    const Real first = f.c[cell] - f.k[0][cell] + f.k[1][cell];
    Leaf<Real> leaf{cells.col[cell],
                    cells.row[cell],
                    cells.inside[cell] != 0,
                    first,
                    ku,
                    kv,
                    f.k[2][cell],
                    f.e[cell],
                    cells.places.s[cell],
                    cells.places.s_radius[cell],
                    cells.from[cell],
                    cells.to[cell],
                    -f.slope_neg_lo[cell],
                    f.slope_hi[cell],
                    f.r[cell],
                    kernel};
    if (pixels < leaf_pixels) {
        small_leaves_.add(leaf);
        return;
    }
    for (int row = 0; row < pixels; row += leaf_pixels) {
        for (int col = 0; col < pixels; col += leaf_pixels) {
            leaf.col = cells.col[cell] + col;
            leaf.row = cells.row[cell] + row;
            leaf.c = first + ku * static_cast<Real>(col) - kv * static_cast<Real>(row);
            if (leaf.col < tile_.cols && leaf.row < tile_.rows) leaves_.add(leaf);
        }
    }
}

template <class Real>
void BeamTile<Real>::march_pixels(std::size_t cell, int pixels, const Kernel* kernel) {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    const auto number = [cell](const std::vector<Real>& column) {
        return static_cast<double>(column[cell]);
    };
    const double half = 0.5 * (pixels - 1);
    const double c = number(f.c);
    const double ku = number(f.k[0]) / half;
    const double kv = number(f.k[1]) / half;
    const double kt = number(f.k[2]);
    const double e = number(f.e) + 0x1p-10 * half * (std::abs(ku) + std::abs(kv));
    const double s = number(cells.places.s);
    const double reach = number(cells.places.s_radius);
    const double scale = std::abs(kt) > 0 ? reach / kt : 0;
    const double radius = std::abs(kt) > 0 ? e * std::abs(scale) + 4 * view_.depth_error()
                                           : std::numeric_limits<double>::infinity();
    const double from = number(cells.from);
    const double to = number(cells.to);
    for (int row = 0; row < pixels && cells.row[cell] + row < tile_.rows; ++row) {
        for (int col = 0; col < pixels && cells.col[cell] + col < tile_.cols; ++col) {
            const double middle = s - (c + ku * (col - half) - kv * (row - half)) * scale;
            double ray_from = std::max(from, middle - radius);
            double ray_to = std::min(to, middle + radius);
            if (!(ray_from <= ray_to)) continue;
            const auto pixel = static_cast<std::uint32_t>((cells.row[cell] + row) * tile_size +
                                                          cells.col[cell] + col);
            if (ray_from > static_cast<double>(found_.depth[pixel])) continue;
            if (cells.inside[cell] == 0) {
                const DepthRange clip = view_.depths(view_.u(cells.col[cell] + col),
                                                     view_.v(cells.row[cell] + row), 0.0, 0.0);
                ray_from = std::max(ray_from, clip.enter_lo);
                ray_to = std::min(ray_to, clip.exit_hi);
                if (!(ray_from <= ray_to)) continue;
            }
            const Real begin = -upper_end(Real{}, -ray_from);
            const Real end = upper_end(Real{}, ray_to);
            marcher_.push({pixel, cells.inside[cell] != 0, begin, end, end - begin, kernel});
        }
    }
}

template <class Real>
void BeamTile<Real>::march_rays() {
    // Cells in this type are decided down to some hundred of its units.
    const double rough = std::max(view_.tolerance(), 256 * tree_.s_most() * unit);
    const bool final = rough <= view_.tolerance();
    const auto stop = [&](std::uint32_t pixel, double from, double to, bool continuous) {
        if (!continuous) {
            pass(pixel, from);
            return true;
        }
        found_.add_pending(pixel, 0.5 * from + 0.5 * to, Certificate::Undecided);
        return false;
    };
    const auto finest = static_cast<Real>(rough);
    marcher_.march({finest, final ? finest / 4 : tree_.margin(), final},
                   [&](const Segment<Real>& segment, bool continuous) {
                       const auto from = static_cast<double>(segment.from);
                       const auto to = static_cast<double>(segment.to);
                       if (final) return stop(segment.pixel, from, to, continuous);
                       fine_marcher_.push(
                           {segment.pixel, segment.inside, from, to, to - from, segment.kernel});
                       return true;
                   });
    fine_marcher_.march({view_.tolerance(), 0.25 * view_.tolerance(), true},
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
    const hn::ScalableTag<double> dd;
    const hn::Rebind<float, decltype(dd)> d;
    const double v = view_.v(row);
    const auto square_up = hn::Set(dd, 1.0 + v * v);
    const auto none = hn::Set(d, std::numeric_limits<float>::infinity());
    const auto first = static_cast<std::size_t>(row) * tile_size;
    for (std::size_t col = 0; col < tile_size; col += hn::Lanes(dd)) {
        const auto s = load_doubles(dd, &found_.depth[first + col]);
        float* const to = &hits_.depth[first + col];
        if (hn::AllFalse(dd, hn::Lt(s, hn::Inf(dd)))) {
            hn::StoreU(none, d, to);
            continue;
        }
        const auto u = hn::MulAdd(hn::Iota(dd, static_cast<double>(col)),
                                  hn::Set(dd, view_.pixel()), hn::Set(dd, view_.u(0)));
        const auto square = hn::MulAdd(u, u, square_up);
        // The root in float, and one step of Newton's method from it.
        const auto near = hn::Sqrt(hn::DemoteTo(d, square));
        const auto root = hn::PromoteTo(dd, near);
        const auto half_inverse =
            hn::PromoteTo(dd, hn::Mul(hn::ApproximateReciprocal(near), hn::Set(d, 0.5F)));
        const auto stretch = hn::MulAdd(hn::NegMulAdd(root, root, square), half_inverse, root);
        const auto depth = hn::Mul(hn::Add(s, hn::Set(dd, view_.distance())), stretch);
        hn::StoreU(hn::DemoteTo(d, depth), d, to);
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
