// The roots on the rays of one tile, by cells from the largest down.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_TILE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_TILE_INL
#undef ZEROSET_BEAM_TILE_INL
#else
#define ZEROSET_BEAM_TILE_INL
#endif

#include "engine/real/scalar.hpp"
#include "engine/trace/beam/beam_cells-inl.hpp"
#include "engine/trace/beam/beam_cuts-inl.hpp"
#include "engine/trace/beam/beam_leaf-inl.hpp"
#include "engine/trace/beam/beam_rays-inl.hpp"
#include "engine/trace/beam/beam_rests-inl.hpp"
#include "engine/trace/beam/beam_roots-inl.hpp"
#include "engine/trace/beam/beam_tree-inl.hpp"
#include "engine/trace/beam/beam_waves-inl.hpp"

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
        : frame_(frame),
          tile_(tile),
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
    /// Leaves cells of this size undecided, from one on.
    void leave_cells(std::size_t first, int pixels);
    void leave_cell(std::size_t cell, int pixels);
    /// Those of a run.
    void visit_run(const CellRun& run, int pixels);
    /// Some cells of one tile that may hold roots: their quarters are made, now or later.
    void divide(const CellRun& run, std::span<const std::size_t> cells, int pixels);
    /// Those of one tile, first to last.
    void visit_tile(const CellRun& run, std::size_t first, std::size_t last, int pixels);
    [[nodiscard]] bool is_accurate(std::size_t cell) const;
    [[nodiscard]] bool is_below_zero(std::size_t cell) const;
    /// Goes on with the cells of tiles that wait.
    void look_closer();
    /// The pixels of a smooth cell.
    void solve_leaf(std::size_t cell, int pixels, const Kernel* kernel);
    /// The pixels of a cell one by one; `pixels` is at most least_pixels.
    void march_pixels(std::size_t cell, int pixels, const Kernel* kernel);
    /// A cell whose pixels go on one by one.
    struct Marched {
        std::size_t cell;
        Real radius;  ///< roots are no farther from where the form's linear part vanishes
        Real by_col;  ///< how much nearer that is from column to column
    };
    LaneBits stretches(const Marched& marched, int first_col, int row, Real middle, Real* froms,
                       Real* tos) const;
    void clip(int col, int row, Real* froms, Real* tos) const;
    /// Finds the roots on single rays.
    void march_rays();
    void pass(std::uint32_t pixel, double s);
    void hand_on();
    void hand_on_row(int row);

    const TraceFrame& frame_;
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
    WaitingTiles<Real, 2 * least_pixels> waiting_;
};

template <class Real>
void BeamTile<Real>::trace() {
    if (tree_.empty()) return;
    found_.begin(hits_, tile_, view_);
    for (int pixels = tile_size; pixels > 2 * least_pixels; pixels /= 2) {
        tree_.begin(pixels);
        descend(pixels);
        tree_.go_down();
    }
    tree_.begin(2 * least_pixels);
    descend(2 * least_pixels);
    look_closer();
    march_rays();
    found_.end();
    hand_on();
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
            pass(static_cast<std::uint32_t>(row * tile_size + col), from);
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
        if (cells.bit(&CellBits::rejected, i)) {
            if (frame_.parts.size() > 1 && is_below_zero(i)) tree_.hide_behind(i, pixels);
            continue;
        }
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
    // The fewer slabs, the less matters in them; where nothing is left out they stay together.
    const std::size_t most = run.kernel->shortener == nullptr ? cells.size : slabs_a_kernel;
    for (std::size_t done = 0; done < open_.size(); done += most)
        divide(run, std::span(open_).subspan(done, std::min(most, open_.size() - done)), pixels);
}

template <class Real>
void BeamTile<Real>::divide(const CellRun& run, std::span<const std::size_t> cells, int pixels) {
    const Kernel* const kernel = tree_.kernel_of(run, cells);
    if (pixels <= 2 * least_pixels)
        return waiting_.push(tree_.cells().tile[cells.front()], kernel, cells);
    tree_.push_children(kernel, cells, pixels, [](int, int) { return Found<Real>::none; });
}

template <class Real>
void BeamTile<Real>::look_closer() {
    while (!waiting_.empty() && !frame_.stopped()) {
        waiting_.divide_some(tree_, found_);
        tree_.go_down();
        descend(least_pixels);
        march_rays();
        tree_.go_up();
    }
    waiting_.for_each([this](std::size_t cell) { leave_cell(cell, 2 * least_pixels); });
}

/// Whether the form tells the depth of the roots to a hundredth of the view's size, a fair guess.
template <class Real>
bool BeamTile<Real>::is_accurate(std::size_t cell) const {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    return f.e[cell] * cells.places.s_radius[cell] < fair_guess_ * std::abs(f.k[2][cell]);
}

/// Of a rejected cell.
template <class Real>
bool BeamTile<Real>::is_below_zero(std::size_t cell) const {
    const Forms<Real>& f = tree_.cells().forms;
    return f.c[cell] < 0 && f.continuous[cell] != 0;
}

template <class Real>
void BeamTile<Real>::solve_leaf(std::size_t cell, int pixels, const Kernel* kernel) {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    const Real half = static_cast<Real>(0.5 * (pixels - 1));
    const Real ku = f.k[0][cell] / half;
    const Real kv = f.k[1][cell] / half;
    const Real first = f.c[cell] - f.k[0][cell] + f.k[1][cell];
    const CellTile tile = cells.tile[cell];
    Leaf<Real> leaf{.col = tile.col(),
                    .row = tile.row(),
                    .inside = tile.inside != 0,
                    .c = first,
                    .ku = ku,
                    .kv = kv,
                    .kt = f.k[2][cell],
                    .e = f.e[cell],
                    .s = cells.places.s[cell],
                    .reach = cells.places.s_radius[cell],
                    .from = cells.from[cell],
                    .to = cells.to[cell],
                    .slope_lo = -f.slope_neg_lo[cell],
                    .slope_hi = f.slope_hi[cell],
                    .r = f.r[cell],
                    .kernel = kernel,
                    .kinked = kernel->branches && f.branches_of(cell).may_hold_kink()};
    if (pixels < leaf_pixels) {
        small_leaves_.add(leaf);
        return;
    }
    for (int row = 0; row < pixels; row += leaf_pixels) {
        for (int col = 0; col < pixels; col += leaf_pixels) {
            leaf.col = tile.col() + col;
            leaf.row = tile.row() + row;
            leaf.c = first + ku * static_cast<Real>(col) - kv * static_cast<Real>(row);
            if (leaf.col < tile_.cols && leaf.row < tile_.rows) leaves_.add(leaf);
        }
    }
}

template <class Real>
void BeamTile<Real>::march_pixels(std::size_t cell, int pixels, const Kernel* kernel) {
    const Cells<Real>& cells = tree_.cells();
    const Forms<Real>& f = cells.forms;
    const Real half = static_cast<Real>(0.5 * (pixels - 1));
    const Real ku = f.k[0][cell] / half;
    const Real kv = f.k[1][cell] / half;
    const Real kt = f.k[2][cell];
    const Real s = cells.places.s[cell];
    const Real reach = cells.places.s_radius[cell];
    const Real error =
        f.e[cell] + static_cast<Real>(0x1p-10 * tile_size) * (std::abs(ku) + std::abs(kv));
    const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * (std::abs(s) + reach);
    const bool steep = std::abs(kt) > 0;
    const Real scale = steep ? reach / kt : 0;
    const Real radius =
        steep ? error * std::abs(scale) + rounding : std::numeric_limits<Real>::infinity();
    const Real first = f.c[cell] - f.k[0][cell] + f.k[1][cell];
    const Marched marched{cell, radius, ku * scale};
    const CellTile tile = cells.tile[cell];
    alignas(64) Real froms[least_pixels * least_pixels], tos[least_pixels * least_pixels];
    LaneBits bits = 0;
    for (int row = 0; row < pixels && tile.row() + row < tile_.rows; ++row) {
        const Real middle = s - (first - kv * static_cast<Real>(row)) * scale;
        for (int col = 0; col < pixels; col += clip_lanes) {
            const int i = row * least_pixels + col;
            const Real at_col = middle - static_cast<Real>(col) * marched.by_col;
            bits |= stretches(marched, col, row, at_col, froms + i, tos + i) << i;
        }
    }
    for (; bits != 0; bits &= bits - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(bits));
        const unsigned pixel = tile.pixel + i / least_pixels * tile_size + i % least_pixels;
        marcher_.push({pixel, tile.inside != 0, froms[i], tos[i], tos[i] - froms[i], kernel});
    }
}

/// Where roots may be on the rays of a vector; returns on which there may be any. `middle`: where
/// the linear part of the form vanishes on the first ray.
template <class Real>
LaneBits BeamTile<Real>::stretches(const Marched& marched, int first_col, int row, Real middle,
                                   Real* froms, Real* tos) const {
    constexpr hn::Rebind<Real, ClipTag> d;
    const Cells<Real>& cells = tree_.cells();
    const CellTile tile = cells.tile[marched.cell];
    const int col = tile.col() + first_col;
    const auto pixel = static_cast<std::size_t>((tile.row() + row) * tile_size + col);
    const auto radius = hn::Set(d, marched.radius);
    const auto middles =
        hn::NegMulAdd(hn::Iota(d, Real{0}), hn::Set(d, marched.by_col), hn::Set(d, middle));
    // The cell's ends where NaN.
    const auto lo = hn::Sub(middles, radius);
    const auto hi = hn::Add(middles, radius);
    const auto cell_from = hn::Set(d, cells.from[marched.cell]);
    const auto cell_to = hn::Set(d, cells.to[marched.cell]);
    hn::Store(hn::IfThenElse(hn::Gt(lo, cell_from), lo, cell_from), d, froms);
    hn::Store(hn::IfThenElse(hn::Lt(hi, cell_to), hi, cell_to), d, tos);
    if (tile.inside == 0) clip(col, tile.row() + row, froms, tos);
    const auto from = hn::Load(d, froms);
    const auto depth = hn::LoadU(d, &found_.depth[pixel]);
    const auto wanted = hn::And(hn::Le(from, hn::Load(d, tos)), hn::Le(from, depth));
    const auto there = static_cast<std::size_t>(std::max(tile_.cols - col, 0));
    return bits_of(d, hn::And(wanted, hn::FirstN(d, there)));
}

/// Takes away what is outside the clip box and region, of stretches of the rays from a pixel on.
template <class Real>
void BeamTile<Real>::clip(int col, int row, Real* froms, Real* tos) const {
    constexpr ClipTag d;
    alignas(64) float cols[clip_lanes], rows[clip_lanes];
    for (int lane = 0; lane < clip_lanes; ++lane) {
        cols[lane] = from_middle(col + lane);
        rows[lane] = from_middle(row);
    }
    auto from = load_doubles(d, froms);
    auto to = load_doubles(d, tos);
    ClipDepths(view_, cols, rows).narrow(from, to);
    alignas(64) double narrow_from[clip_lanes], narrow_to[clip_lanes];
    hn::Store(from, d, narrow_from);
    hn::Store(to, d, narrow_to);
    for (int lane = 0; lane < clip_lanes; ++lane) {
        froms[lane] = -upper_end(Real{}, -narrow_from[lane]);
        tos[lane] = upper_end(Real{}, narrow_to[lane]);
    }
}

template <class Real>
void BeamTile<Real>::march_rays() {
    roots_.solve();
    for (const Stretch& stretch : roots_.take_open()) {
        const Real from = -upper_end(Real{}, -stretch.from);
        const Real to = upper_end(Real{}, stretch.to);
        marcher_.push({stretch.pixel, stretch.inside, from, to, to - from, stretch.kernel});
    }
    // Cells in this type are decided down to some hundred of its units, then in double.
    const double rough = std::max(view_.tolerance(), 256 * tree_.s_most() * unit);
    const auto finest = static_cast<Real>(rough);
    marcher_.march({finest, tree_.margin(), false}, [&](const Segment<Real>& segment, bool) {
        const auto from = static_cast<double>(segment.from);
        const auto to = static_cast<double>(segment.to);
        fine_marcher_.push({segment.pixel, segment.inside, from, to, to - from, segment.kernel});
        return true;
    });
    const MarchSettings<double> fine{view_.tolerance(), 0.25 * view_.tolerance(), true};
    const auto stop = [&](const Segment<double>& segment, bool continuous) {
        if (!continuous) {
            pass(segment.pixel, segment.from);
            return true;
        }
        found_.add_pending(segment.pixel, 0.5 * segment.from + 0.5 * segment.to,
                           Certificate::Undecided, Trend::Unknown);
        return false;
    };
    fine_marcher_.march(fine, stop);
    fine_marcher_.settle(roots_.take_doubts(), fine, stop);
}

template <class Real>
void BeamTile<Real>::hand_on() {
    hits_.any = found_.any();
    hits_.point_errors = {view_.tolerance(), view_.depth_error()};
    for (const auto& root : found_.pending) {
        const auto depth = static_cast<double>(found_.depth[root.pixel]);
        const double rounding = 4 * unit * std::abs(depth) + view_.tolerance();
        if (!(std::abs(depth - root.s) <= rounding)) continue;  // there is a nearer one
        const glm::dvec3 x = view_.point(root.pixel % tile_size, root.pixel / tile_size, root.s);
        hits_.points.push_back({root.pixel, {x.x, x.y, x.z}, root.trend});
    }
    for (int row = 0; row < tile_.rows && hits_.any; ++row)
        hand_on_row(row);
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
    const auto first = static_cast<std::size_t>(row) * tile_size;
    for (std::size_t col = 0; col < tile_size; col += hn::Lanes(dd)) {
        const auto s = load_doubles(dd, &found_.depth[first + col]);
        if (hn::AllFalse(dd, hn::Lt(s, hn::Inf(dd)))) continue;
        const auto u = hn::MulAdd(hn::Iota(dd, static_cast<double>(col)),
                                  hn::Set(dd, view_.pixel()), hn::Set(dd, view_.u(0)));
        const auto stretch = hn::Sqrt(hn::MulAdd(u, u, square_up));
        const auto depth = hn::Mul(hn::Add(s, hn::Set(dd, view_.look_distance())), stretch);
        hn::StoreU(hn::DemoteTo(d, depth), d, &hits_.depth[first + col]);
    }
}

/// A cell on the ray of a pixel, from s on, that was not decided.
template <class Real>
void BeamTile<Real>::pass(std::uint32_t pixel, double s) {
    hits_.pass({static_cast<std::int16_t>(pixel % tile_size),
                static_cast<std::int16_t>(pixel / tile_size)},
               view_.distance_before(s, view_.u(pixel % tile_size), view_.v(pixel / tile_size)));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
