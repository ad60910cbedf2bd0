// The roots on the rays of one tile, by cells from the largest down. How single rays are searched:
// beam_tile_rays-inl.hpp.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_TILE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_TILE_INL
#undef ZEROSET_BEAM_TILE_INL
#else
#define ZEROSET_BEAM_TILE_INL
#endif

#include "engine/real/scalar.hpp"
#include "engine/trace/beam/beam_cells-inl.hpp"
#include "engine/trace/beam/beam_leaf-inl.hpp"
#include "engine/trace/beam/beam_rays-inl.hpp"
#include "engine/trace/beam/beam_roots-inl.hpp"
#include "engine/trace/beam/beam_tree-inl.hpp"
#include "engine/trace/beam/beam_waves-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Memory that a thread keeps from tile to tile.
template <class Real>
struct BeamMemory {
    TreeMemory<Real> tree;
    NearestRoots<Real> nearest;
    MarchMemory<Real> march;
    MarchMemory<double> fine_march;
};

/// How often something was met on each ray of a tile.
class PixelCounts {
public:
    /// Counts once more, unless there are `most` already; whether there are.
    bool are(std::uint32_t pixel, std::uint16_t most) {
        if (counts_[pixel] >= most) return true;
        ++counts_[pixel];
        return false;
    }

private:
    std::array<std::uint16_t, std::size_t{tile_size} * tile_size> counts_{};
};

/// The search in one tile.
template <class Real>
class BeamTile {
public:
    /// `asked`: the width of brackets that is asked for, not below the tolerance of the frame.
    BeamTile(const TraceFrame& frame, double asked, const Tile& tile, BeamMemory<Real>& memory,
             TileHits& hits, Counters& counters)
        : frame_(frame),
          asked_(asked),
          tile_(tile),
          hits_(hits),
          rays_(frame, tile),
          tree_(frame, tile, rays_, memory.tree, counters),
          nearest_(memory.nearest),
          roots_(frame, rays_, asked, nearest_, counters),
          leaves_(frame, tile, rays_, nearest_, roots_, counters),
          small_leaves_(frame, tile, rays_, nearest_, roots_, counters),
          marcher_(frame, rays_, memory.march, nearest_, roots_, counters),
          fine_marcher_(frame, rays_, memory.fine_march, nearest_, roots_, counters),
          fair_guess_(static_cast<Real>(0.005 * rays_.extent())) {}

    void trace();

private:
    static constexpr auto unit = static_cast<double>(std::numeric_limits<Real>::epsilon());

    /// Judges the cells of one size and makes their children.
    void descend(int pixels);
    /// Leaves cells of this size undecided, from one on.
    void leave_cells(std::size_t first, int pixels);
    void leave_cell(std::size_t cell, int pixels);
    /// Visits the cells of a run.
    void visit_run(const CellRun& run, int pixels);
    /// Makes the quarters of some cells of one tile that may hold roots, now or later.
    void divide(const CellRun& run, std::span<const std::size_t> cells, int pixels);
    /// Visits the cells of one tile, from first to before last.
    void visit_tile(const CellRun& run, std::size_t first, std::size_t last, int pixels);
    /// Whether the form tells the depth of the roots to a hundredth of the view's size, a fair
    /// guess.
    [[nodiscard]] bool is_accurate(std::size_t cell) const;
    /// Whether f < 0 in all of a rejected cell.
    [[nodiscard]] bool is_below_zero(std::size_t cell) const;
    /// Whether normal . view may change much within a pixel of the cell.
    [[nodiscard]] bool turns(std::size_t cell, int pixels) const;
    /// Goes on with the cells of tiles that wait.
    void look_closer();
    /// The linear part of a cell's form in pixels, at the middle of the cell's slab.
    struct PixelForm {
        Real first;   ///< at the cell's first pixel
        Real ku, kv;  ///< how much larger it is one pixel to the right, and one upwards

        /// At x pixels right and y below the first pixel.
        [[nodiscard]] Real at(Real x, Real y) const { return first + ku * x - kv * y; }
    };
    [[nodiscard]] PixelForm pixel_form(std::size_t cell, int pixels) const {
        const Forms<Real>& f = tree_.cells().forms;
        const auto radius = static_cast<Real>(rays_.radius_of(pixels));
        const auto first = static_cast<Real>(TileRays::middle_of(pixels) / rays_.radius_of(pixels));
        return {f.c[cell] - first * f.k[0][cell] + first * f.k[1][cell], f.k[0][cell] / radius,
                f.k[1][cell] / radius};
    }
    /// Solves the pixels of a smooth cell.
    void solve_leaf(std::size_t cell, int pixels, const Kernel* kernel);
    /// Hands over the pixels of a cell to be searched one by one; `pixels` is at most least_pixels.
    void march_pixels(std::size_t cell, int pixels, const Kernel* kernel);
    /// A cell whose pixels are searched one by one, where its form's linear part tells.
    struct LinearCell {
        std::size_t cell;
        Real radius;  ///< roots are no farther from where the form's linear part vanishes
        Real by_col;  ///< how much nearer that is from column to column
    };
    /// Marks the cell's pixels on any of whose rays a root may be.
    void leave_pixels(const LinearCell& linear, const PixelForm& form, int pixels);
    /// Stores where roots may be on the rays of a vector; returns on which there may be any.
    /// `middle`: where the linear part of the form vanishes on the first ray.
    LaneBits store_brackets(const LinearCell& linear, int first_col, int row, Real middle,
                            Real* froms, Real* tos) const;
    /// Takes away what is outside the clip box and region from brackets on the rays from a pixel
    /// on.
    void clip(int col, int row, Real* froms, Real* tos) const;
    /// Finds the roots on single rays.
    void march_rays();
    /// Marks the ray of a pixel: a cell from s on was not decided.
    void mark_unsettled(std::uint32_t pixel, double s);
    /// Writes what was found to the hits.
    void write_hits();
    /// Turns a row's depths along the view axis into distances along the rays.
    void write_row(int row);

    const TraceFrame& frame_;
    double asked_;
    const Tile& tile_;
    TileHits& hits_;
    TileRays rays_;
    CellTree<Real> tree_;
    NearestRoots<Real>& nearest_;
    RootFinder<Real> roots_;
    LeafSolver<Real, leaf_pixels> leaves_;
    LeafSolver<Real, least_pixels> small_leaves_;
    RayMarcher<Real, Real> marcher_;
    RayMarcher<double, Real> fine_marcher_;
    Real fair_guess_;
    std::vector<std::size_t> open_;  ///< cells of the tile at work that go on to its children
    WaitingTiles<Real, 2 * least_pixels> waiting_;
    PixelCounts handed_over_;  ///< parts of rays that are left to the search in double
    PixelCounts unsettled_;    ///< parts of rays that are left unsettled
};

template <class Real>
void BeamTile<Real>::trace() {
    nearest_.cover.begin(frame_.whole_pixels, hits_.cover);
    if (tree_.empty()) return;
    nearest_.begin(hits_, tile_, rays_);
    for (int pixels = tile_size; pixels > 2 * least_pixels; pixels /= 2) {
        tree_.begin(pixels);
        descend(pixels);
        tree_.go_down();
    }
    tree_.begin(2 * least_pixels);
    descend(2 * least_pixels);
    look_closer();
    march_rays();
    nearest_.end();
    nearest_.cover.end(nearest_.s);
    write_hits();
}

template <class Real>
void BeamTile<Real>::descend(int pixels) {
    if (tree_.cells().size == 0) return;
    if (frame_.stopped()) return leave_cells(0, pixels);
    for (const CellRun& run : tree_.judge(pixels)) {
        if (frame_.stopped()) return leave_cells(run.first, pixels);
        visit_run(run, pixels);
    }
}

template <class Real>
void BeamTile<Real>::leave_cells(std::size_t first, int pixels) {
    for (std::size_t cell = first; cell < tree_.cells().size; ++cell)
        leave_cell(cell, pixels);
}

template <class Real>
void BeamTile<Real>::leave_cell(std::size_t cell, int pixels) {
    const CellTile tile = tree_.cells().tile[cell];
    const auto from = static_cast<double>(tree_.cells().from[cell]);
    for (int row = tile.row(); row < std::min(tile.row() + pixels, tile_.rows); ++row) {
        for (int col = tile.col(); col < std::min(tile.col() + pixels, tile_.cols); ++col)
            mark_unsettled(static_cast<std::uint32_t>(row * tile_size + col), from);
    }
}

template <class Real>
void BeamTile<Real>::visit_run(const CellRun& run, int pixels) {
    const Cells<Real>& cells = tree_.cells();
    const std::size_t end = run.first + run.count;
    for (std::size_t first = run.first; first < end;) {
        std::size_t last = first + 1;
        while (last < end && cells.tile[last].pixel == cells.tile[first].pixel)
            ++last;
        visit_tile(run, first, last, pixels);
        first = last;
    }
}

template <class Real>
void BeamTile<Real>::visit_tile(const CellRun& run, std::size_t first, std::size_t last,
                                int pixels) {
    const Cells<Real>& cells = tree_.cells();
    open_.clear();
    const Real hidden = tree_.hidden_from(cells.tile[first], pixels);
    for (std::size_t i = first; i < last && cells.from[i] < hidden; ++i) {
        // Leave rejected cells; in a union, those where a part is below 0 hide what is behind them.
        if (cells.bit(&CellBits::rejected, i)) {
            if (frame_.union_members.size() > 1 && is_below_zero(i)) tree_.hide_behind(i, pixels);
            continue;
        }
        // Solve smooth cells, march through the smallest ones, divide the others.
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
        // Leave what is behind a root on every ray.
        if (!finished) continue;
        tree_.hide_behind(i, pixels);
        break;
    }
    leaves_.solve();
    small_leaves_.solve();
    // The fewer slabs, the less matters in them; where nothing is left out they stay together.
    const std::size_t most = run.kernel->specializer == nullptr ? cells.size : slabs_a_kernel;
    for (std::size_t done = 0; done < open_.size(); done += most)
        divide(run, std::span(open_).subspan(done, std::min(most, open_.size() - done)), pixels);
}

template <class Real>
void BeamTile<Real>::divide(const CellRun& run, std::span<const std::size_t> cells, int pixels) {
    const Kernel* const kernel = tree_.kernel_of(run, cells);
    if (pixels <= 2 * least_pixels)
        return waiting_.push(tree_.cells().tile[cells.front()], kernel, cells);
    tree_.push_children(kernel, cells, pixels, [](int, int) { return NearestRoots<Real>::none; });
}

template <class Real>
void BeamTile<Real>::look_closer() {
    while (!waiting_.empty() && !frame_.stopped()) {
        waiting_.divide_some(tree_, nearest_);
        tree_.go_down();
        descend(least_pixels);
        march_rays();
        tree_.go_up();
    }
    waiting_.for_each([this](std::size_t cell) { leave_cell(cell, 2 * least_pixels); });
}

template <class Real>
bool BeamTile<Real>::is_accurate(std::size_t cell) const {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    return f.e[cell] * cells.places.s_radius[cell] < fair_guess_ * std::abs(f.k[2][cell]);
}

template <class Real>
bool BeamTile<Real>::is_below_zero(std::size_t cell) const {
    const Forms<Real>& f = tree_.cells().forms;
    return f.c[cell] < 0 && f.continuous[cell] != 0;
}

template <class Real>
bool BeamTile<Real>::turns(std::size_t cell, int pixels) const {
    constexpr Real most = 0.5;
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    // The form's linear part is f's gradient, in parts of the cell's radii.
    const Real half =
        static_cast<Real>(rays_.radius_of(pixels) * rays_.pixel() *
                          (rays_.distance() + static_cast<double>(cells.places.s[cell])));
    const Real across = std::abs(f.k[0][cell]) + std::abs(f.k[1][cell]);
    const Real along = std::abs(f.k[2][cell]);
    // A pixel's part of the change, unless it is uneven.
    const Real change =
        (f.slope_hi[cell] + f.slope_neg_lo[cell]) * (2 / (most * static_cast<Real>(pixels)));
    return !(change * half <= across || change * cells.places.s_radius[cell] <= along);
}

template <class Real>
void BeamTile<Real>::solve_leaf(std::size_t cell, int pixels, const Kernel* kernel) {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    const PixelForm form = pixel_form(cell, pixels);
    const CellTile tile = cells.tile[cell];
    Leaf<Real> leaf{.col = tile.col(),
                    .row = tile.row(),
                    .inside = tile.inside != 0,
                    .c = form.first,
                    .ku = form.ku,
                    .kv = form.kv,
                    .kt = f.k[2][cell],
                    .e = f.e[cell],
                    .s = cells.places.s[cell],
                    .s_radius = cells.places.s_radius[cell],
                    .from = cells.from[cell],
                    .to = cells.to[cell],
                    .slope_lo = -f.slope_neg_lo[cell],
                    .slope_hi = f.slope_hi[cell],
                    .r = f.r[cell],
                    .kernel = kernel,
                    .kinked = kernel->branches && f.branches_of(cell).may_hold_kink(),
                    .turns = nearest_.cover.wanted() && turns(cell, pixels)};
    if (pixels < leaf_pixels) {
        small_leaves_.add(leaf);
        return;
    }
    for (int row = 0; row < pixels; row += leaf_pixels) {
        for (int col = 0; col < pixels; col += leaf_pixels) {
            leaf.col = tile.col() + col;
            leaf.row = tile.row() + row;
            leaf.c = form.at(static_cast<Real>(col), static_cast<Real>(row));
            if (leaf.col < tile_.cols && leaf.row < tile_.rows) leaves_.add(leaf);
        }
    }
}

template <class Real>
void BeamTile<Real>::write_hits() {
    hits_.any = nearest_.any();
    hits_.point_errors = {.bracket = rays_.tolerance(), .depth = rays_.depth_error()};
    // Leave the gradients of these points to be found.
    for (const auto& root : nearest_.pending) {
        const auto depth = static_cast<double>(nearest_.s[root.pixel]);
        const double rounding = 4 * unit * std::abs(depth) + rays_.tolerance();
        if (!(std::abs(depth - root.s) <= rounding)) continue;  // there is a nearer one
        const glm::dvec3 x = rays_.point(root.pixel % tile_size, root.pixel / tile_size, root.s);
        hits_.points.push_back({root.pixel, {x.x, x.y, x.z}, root.trend});
    }
    for (int row = 0; row < tile_.rows && hits_.any; ++row)
        write_row(row);
    // Nothing is certified behind an unsettled cell.
    if (!hits_.any_unsettled) return;
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
        if (hits_.unsettled[pixel] <= hits_.depth[pixel])
            hits_.certificate[pixel] = Certificate::Undecided;
    }
}

template <class Real>
void BeamTile<Real>::write_row(int row) {
    const hn::ScalableTag<double> dd;
    const hn::Rebind<float, decltype(dd)> df;
    const double v = rays_.v(row);
    const auto square_up = hn::Set(dd, 1.0 + v * v);
    const auto first = static_cast<std::size_t>(row) * tile_size;
    for (std::size_t col = 0; col < tile_size; col += hn::Lanes(dd)) {
        const auto s = load_doubles(dd, &nearest_.s[first + col]);
        if (hn::AllFalse(dd, hn::Lt(s, hn::Inf(dd)))) continue;
        const auto u = hn::MulAdd(hn::Iota(dd, static_cast<double>(col)),
                                  hn::Set(dd, rays_.pixel()), hn::Set(dd, rays_.u(0)));
        const auto stretch = hn::Sqrt(hn::MulAdd(u, u, square_up));
        const auto distance = hn::Mul(hn::Add(s, hn::Set(dd, rays_.look_distance())), stretch);
        hn::StoreU(hn::DemoteTo(df, distance), df, &hits_.depth[first + col]);
    }
}

template <class Real>
void BeamTile<Real>::mark_unsettled(std::uint32_t pixel, double s) {
    nearest_.cover.leave(pixel, s, std::numeric_limits<double>::infinity());
    hits_.mark_unsettled(
        {.col = static_cast<std::int16_t>(pixel % tile_size),
         .row = static_cast<std::int16_t>(pixel / tile_size)},
        rays_.distance_before(s, rays_.u(pixel % tile_size), rays_.v(pixel / tile_size)));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
