// The cells of a tile, from the first ones down to the smallest.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_TREE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_TREE_INL
#undef ZEROSET_BEAM_TREE_INL
#else
#define ZEROSET_BEAM_TREE_INL
#endif

#include "engine/trace/beam/beam_pieces-inl.hpp"
#include "engine/trace/beam/beam_ranges-inl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

constexpr int leaf_pixels = 8;   ///< tiles of this size are solved where f is monotone
constexpr int least_pixels = 4;  ///< smaller tiles are not made
constexpr int least_tiles = tile_size / least_pixels;
constexpr int first_slabs = 8;
constexpr double most_slabs = first_slabs;
constexpr int most_parts = 4;  ///< into which a slab is cut at once
/// Cells of so many neighbouring slabs of a tile share a shortened kernel.
constexpr std::size_t slabs_a_kernel = 4;

/// Room for cells piece by piece.
template <class Real>
struct PieceMemory {
    Pieces<Real> pieces;
    Cells<Real> cells;  ///< as many as there are pieces
    /// Of each cell of a list where a root may be in some piece, for each quarter of its tile.
    struct Left {
        bool any = false;
        std::array<Real, 4> from, to;
    };
    std::vector<Left> left;
};

/// What a CellTree keeps from tile to tile.
template <class Real>
struct TreeMemory {
    Cells<Real> cells[2];
    CellKernels kernels;
    PieceMemory<Real> pieces;
    RangeMemory<Real> ranges;
    std::vector<std::size_t> asked;
    /// Beyond these depths nothing is looked for: for each of the smallest tiles, in rows.
    std::array<Real, least_tiles * least_tiles> hidden;
};

/// Cells of one size after the other: what kernels say of them, and those of the next size.
template <class Real>
class CellTree {
public:
    CellTree(const TraceFrame& frame, const Tile& tile, const BeamView& view,
             TreeMemory<Real>& memory, Counters& counters)
        : frame_(frame),
          tile_(tile),
          view_(view),
          counters_(counters),
          cells_(&memory.cells[0]),
          next_(&memory.cells[1]),
          kernels_(memory.kernels),
          pieces_(memory.pieces),
          asked_(memory.asked),
          hidden_(memory.hidden),
          ranges_(frame, view, memory.ranges, counters),
          distance_(static_cast<Real>(view.distance())) {
        start();
    }

    [[nodiscard]] const Cells<Real>& cells() const { return *cells_; }
    /// Whether no ray meets the clip box.
    [[nodiscard]] bool empty() const { return depths_.empty(); }
    /// The first cells of those that begin as tiles of this size.
    void begin(int pixels);
    /// Evaluates and judges the cells, tiles of this size; they are runs of the same kernel.
    std::span<const CellRun> judge(int pixels);
    /// The depth before which every ray of a tile, of this size, surely has a root: what begins
    /// there or behind it is hidden. Nothing smaller than its quarters has been hidden yet.
    [[nodiscard]] HWY_INLINE Real hidden_from(CellTile tile, int pixels) const;
    /// Every ray of the cell's tile, of this size, surely has a root in it.
    void hide_behind(std::size_t cell, int pixels) {
        hide(cells_->tile[cell], pixels, cells_->to[cell]);
    }
    /// Makes the quarters of a tile, for `open`: its cells that may hold roots, with the kernel of
    /// f in them. `farthest(col, row)` is the depth from which on nothing is wanted in the quarter
    /// that begins there.
    void push_children(const Kernel* kernel, std::span<const std::size_t> open, int pixels,
                       auto farthest);
    /// Goes on with the cells that were pushed.
    void go_down() {
        std::swap(cells_, next_);
        next_->clear();
    }
    /// Goes back to the cells from which it went down; nothing was pushed since.
    void go_up() { go_down(); }
    /// Of f in some cells of the run, or in one.
    const Kernel* kernel_of(const CellRun& run, std::span<const std::size_t> cells) {
        return kernels_.shortened(run, cells);
    }
    const Kernel* kernel_of(const CellRun& run, std::size_t cell) {
        return kernel_of(run, std::span(&cell, 1));
    }
    /// Not below |s| in any cell.
    [[nodiscard]] double s_most() const { return s_most_; }
    /// All cells are longer than their slabs by more than this at both ends.
    [[nodiscard]] Real margin() const { return margin_; }

private:
    /// A quarter of the tile at work.
    struct Child {
        CellTile tile;  ///< inside, for the cells that are
        std::size_t index;
        DepthRange depths;  ///< of its rays, where some cell of the tile is not inside the clip box
        Real hidden;        ///< see hidden_from
        Real width_by_depth;  ///< twice the tile's width at the distance 1 from the eye
    };

    void start();
    /// The first cells of one tile: `kernel` between depths, in so many slabs.
    struct First {
        const Kernel* kernel;
        int col, row;
        double from, to;
        int slabs;
    };
    void push_first(const First& first, const DepthRange& depths);
    /// Of a size, first to last of each, counted in tiles.
    struct Tiles {
        int first_col, last_col, first_row, last_row;

        [[nodiscard]] int count() const {
            return (last_col - first_col + 1) * (last_row - first_row + 1);
        }
    };
    /// Those that the part may be in.
    [[nodiscard]] Tiles tiles_of(const PartInView& part, int pixels) const;
    /// The smallest tiles of which few cover the part: with these it begins.
    [[nodiscard]] int first_pixels(const PartInView& part) const;
    void push_part(const PartInView& part, int pixels);
    /// Cells in which switches are open, by what each piece of f leaves.
    void narrow_by_pieces(const CellRun& run, const FrustumOf<Real>& frustum, int pixels);
    /// By natural interval extensions, cells on which f is not known to be continuous or its form
    /// says nothing: they are sharper beside poles and jumps, and where numbers overflow. They tell
    /// where f is 0 in the whole cell, too.
    void reject_by_ranges(const CellRun& run, int pixels);
    HWY_INLINE void push_child(const Child& child, int pixels, std::size_t parent);
    void hide(CellTile tile, int pixels, Real to);

    [[nodiscard]] DepthRange depths_of(int col, int row, int pixels) const {
        const double half = 0.5 * (pixels - 1);
        return view_.depths(view_.u(col + half), view_.v(row + half), half * view_.pixel(),
                            half * view_.pixel());
    }
    /// How much longer than their slabs cells are: from size to size a little less, so that they
    /// lie in those that their kernels were shortened for.
    [[nodiscard]] Real margin_of(int pixels) const {
        return margin_ *
               static_cast<Real>(0.75 + 0.25 * std::bit_width(static_cast<unsigned>(pixels)));
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    const BeamView& view_;
    Counters& counters_;
    Cells<Real>* cells_;
    Cells<Real>* next_;
    CellKernels& kernels_;
    PieceMemory<Real>& pieces_;
    std::vector<std::size_t>& asked_;  ///< cells in ranges_
    std::array<Real, least_tiles * least_tiles>& hidden_;
    RangeList<Real> ranges_;
    Real distance_;        ///< from the eye to the plane s = 0
    DepthRange depths_{};  ///< of the rays; they leave where nothing is wanted any more
    double s_most_ = 0;
    Real margin_ = 0;
};

template <class Real>
void CellTree<Real>::start() {
    cells_->clear();
    next_->clear();
    kernels_.clear();
    hidden_.fill(std::numeric_limits<Real>::infinity());
    const double half = 0.5 * (tile_size - 1);
    const double radius = half * view_.pixel();
    depths_ = view_.depths(view_.u(half), view_.v(half), radius, radius);
    s_most_ = std::max(std::abs(depths_.enter_lo), std::abs(depths_.exit_hi)) * (1.0 + 0x1p-10);
    depths_.exit_hi = std::min(depths_.exit_hi, view_.limit());
    const auto unit = static_cast<double>(std::numeric_limits<Real>::epsilon());
    const double finest = std::max(view_.tolerance(), 8 * s_most_ * unit);
    margin_ = static_cast<Real>(2 * finest);
}

template <class Real>
void CellTree<Real>::begin(int pixels) {
    for (const PartInView& part : frame_.parts) {
        if (first_pixels(part) == pixels) push_part(part, pixels);
    }
    if (!frame_.parts.empty() || pixels != tile_size) return;
    push_first({&frame_.kernel, 0, 0, depths_.enter_lo, depths_.exit_hi, first_slabs}, depths_);
}

template <class Real>
void CellTree<Real>::push_first(const First& first, const DepthRange& depths) {
    cells_->runs.begin(first.kernel, cells_->size);
    cells_->make_room(static_cast<std::size_t>(first.slabs));
    const Real near = -upper_end(Real{}, -first.from);
    const Real far = upper_end(Real{}, first.to);
    Real from = near;
    for (int i = 1; i <= first.slabs; ++i) {
        const Real part = static_cast<Real>(i) / static_cast<Real>(first.slabs);
        const Real to = i == first.slabs ? far : near + (far - near) * part;
        const bool inside = static_cast<double>(from) >= depths.enter_hi &&
                            static_cast<double>(to) <= depths.exit_lo;
        cells_->push(CellTile::at(first.col, first.row, inside), from, to);
        from = to;
    }
}

template <class Real>
auto CellTree<Real>::tiles_of(const PartInView& part, int pixels) const -> Tiles {
    const auto tile_at = [&](double place, int begin, int count) {
        return static_cast<int>(std::clamp(place - begin, 0.0, count - 1.0)) / pixels;
    };
    return {tile_at(part.first_col, tile_.col, tile_.cols),
            tile_at(part.last_col, tile_.col, tile_.cols),
            tile_at(part.first_row, tile_.row, tile_.rows),
            tile_at(part.last_row, tile_.row, tile_.rows)};
}

template <class Real>
int CellTree<Real>::first_pixels(const PartInView& part) const {
    constexpr int most_tiles = 12;  // with some slabs they are about a batch
    int pixels = tile_size;
    while (pixels > leaf_pixels && tiles_of(part, pixels / 2).count() <= most_tiles)
        pixels /= 2;
    return pixels;
}

template <class Real>
void CellTree<Real>::push_part(const PartInView& part, int pixels) {
    const double from = std::max(part.from, depths_.enter_lo);
    const double to = std::min(part.to, depths_.exit_hi);
    if (!(from <= to)) return;
    const bool inside = from >= depths_.enter_hi && to <= depths_.exit_lo;
    const double width = view_.pixel() * pixels * (view_.distance() + from);
    const int slabs = static_cast<int>(std::clamp((to - from) / width + 0.5, 1.0, most_slabs));
    const Tiles tiles = tiles_of(part, pixels);
    const double half = 0.5 * (pixels - 1);
    const double radius = half * view_.pixel();
    for (int row = tiles.first_row * pixels; row <= tiles.last_row * pixels; row += pixels) {
        for (int col = tiles.first_col * pixels; col <= tiles.last_col * pixels; col += pixels) {
            const DepthRange depths =
                inside ? depths_
                       : view_.depths(view_.u(col + half), view_.v(row + half), radius, radius);
            const double begin = std::max(from, depths.enter_lo);
            const double end = std::min(to, depths.exit_hi);
            if (begin <= end) push_first({part.kernel, col, row, begin, end, slabs}, depths);
        }
    }
}

template <class Real>
std::span<const CellRun> CellTree<Real>::judge(int pixels) {
    const FrustumOf<Real> frustum = view_.frustum<Real>(pixels);
    cells_->runs.end(cells_->size);
    cells_->place(view_, pixels, margin_of(pixels));
    for (CellRun& run : cells_->runs.all())
        evaluate(frame_, frustum, run, cells_->places, cells_->forms, counters_);
    CellJudge<Real>(pixels).judge(*cells_);
    for (const CellRun& run : cells_->runs.all()) {
        if (run.kernel->switches > 0 && !frame_.scene.jumps) narrow_by_pieces(run, frustum, pixels);
        reject_by_ranges(run, pixels);
    }
    return cells_->runs.all();
}

template <class Real>
void CellTree<Real>::narrow_by_pieces(const CellRun& run, const FrustumOf<Real>& frustum,
                                      int pixels) {
    constexpr int most_switches = 1;
    Cells<Real>& of = pieces_.cells;
    pieces_.pieces.begin(run.kernel->switches);
    pieces_.left.assign(run.count, {});
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        const BranchBits branches = cells_->forms.branches_of(i);
        if (branches.outcomes() == 0 || cells_->bit(&CellBits::rejected, i)) continue;
        pieces_.pieces.push(i, branches);
    }
    const CellJudge<Real> judge(pixels);
    const auto evaluate = [&](PieceList<Real>& list) {
        of.clear();
        of.make_room(list.size());
        for (std::size_t k = 0; k < list.size(); ++k)
            of.push_copy(*cells_, list.cell(k));
        of.places.pad(of.size);
        counters_.form += of.size;
        run.kernel->form(
            form_batch(frame_, *run.kernel, frustum, 0, of.size, of.places, of.forms, list.held()));
        judge.judge(of);
    };
    const auto keep = [&](std::size_t cell, std::size_t k) {
        auto& left = pieces_.left[cell - run.first];
        for (std::size_t q = 0; q < 4; ++q) {
            const Real from = of.child_from[q][k];
            const Real to = of.child_to[q][k];
            const bool empty = !(from <= to);
            left.from[q] = left.any ? std::min(left.from[q], from) : from;
            if (!left.any) left.to[q] = -std::numeric_limits<Real>::infinity();
            if (!empty) left.to[q] = std::max(left.to[q], to);
        }
        left.any = true;
    };
    pieces_.pieces.visit(
        most_switches, evaluate, [&](std::size_t k) { return of.bit(&CellBits::rejected, k); },
        [&](std::size_t k) { return of.forms.branches_of(k); }, keep);
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        if (cells_->forms.branches_of(i).outcomes() == 0 || cells_->bit(&CellBits::rejected, i))
            continue;
        const auto& left = pieces_.left[i - run.first];
        if (!left.any) {
            cells_->set_bit(&CellBits::rejected, i);
            continue;
        }
        for (std::size_t q = 0; q < 4; ++q) {
            cells_->child_from[q][i] = std::max(cells_->child_from[q][i], left.from[q]);
            cells_->child_to[q][i] = std::min(cells_->child_to[q][i], left.to[q]);
        }
    }
}

template <class Real>
void CellTree<Real>::reject_by_ranges(const CellRun& run, int pixels) {
    ranges_.clear();
    asked_.clear();
    const double half = 0.5 * (pixels - 1);
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        const bool told = cells_->forms.continuous[i] != 0 && cells_->forms.known(i) &&
                          !cells_->bit(&CellBits::flat, i);
        if (told || cells_->bit(&CellBits::rejected, i)) continue;
        asked_.push_back(i);
        ranges_.push(view_.u(cells_->tile[i].col() + half), view_.v(cells_->tile[i].row() + half),
                     half * view_.pixel(), half * view_.pixel(),
                     static_cast<double>(cells_->from[i]), static_cast<double>(cells_->to[i]));
    }
    ranges_.evaluate(*run.kernel);
    for (std::size_t k = 0; k < asked_.size(); ++k) {
        if (ranges_.excludes_zero(k)) cells_->set_bit(&CellBits::rejected, asked_[k]);
        if (ranges_.vanishes(k) && cells_->tile[asked_[k]].inside != 0) cells_->finish(asked_[k]);
    }
}

template <class Real>
HWY_INLINE Real CellTree<Real>::hidden_from(CellTile tile, int pixels) const {
    const auto at = [&](int row, int col) {
        return hidden_[static_cast<std::size_t>(row / least_pixels * least_tiles +
                                                col / least_pixels)];
    };
    const int half = pixels / 2;
    const int row = tile.row();
    const int col = tile.col();
    return std::max(std::max(at(row, col), at(row, col + half)),
                    std::max(at(row + half, col), at(row + half, col + half)));
}

template <class Real>
void CellTree<Real>::hide(CellTile tile, int pixels, Real to) {
    for (int r = tile.row() / least_pixels; r < (tile.row() + pixels) / least_pixels; ++r) {
        for (int c = tile.col() / least_pixels; c < (tile.col() + pixels) / least_pixels; ++c) {
            Real& depth = hidden_[static_cast<std::size_t>(r * least_tiles + c)];
            depth = std::min(depth, to);
        }
    }
}

template <class Real>
void CellTree<Real>::push_children(const Kernel* kernel, std::span<const std::size_t> open,
                                   int pixels, auto farthest) {
    const int half = pixels / 2;
    const auto width_by_depth = static_cast<Real>(2 * view_.pixel() * half);
    const CellTile parent = cells_->tile[open.front()];
    next_->runs.begin(kernel, next_->size);
    next_->make_room(4 * most_parts * open.size());
    const bool all_inside =
        std::ranges::all_of(open, [&](std::size_t cell) { return cells_->tile[cell].inside != 0; });
    for (std::size_t child = 0; child < 4; ++child) {
        const int col = parent.col() + ((child & 1U) != 0 ? half : 0);
        const int row = parent.row() + ((child & 2U) != 0 ? half : 0);
        if (col >= tile_.cols || row >= tile_.rows) continue;
        const Real limit = farthest(col, row);
        const CellTile tile = CellTile::at(col, row, true);
        const DepthRange depths = all_inside ? DepthRange{} : depths_of(col, row, half);
        const Child quarter{tile, child, depths, hidden_from(tile, half), width_by_depth};
        for (const std::size_t cell : open) {
            if (cells_->from[cell] > limit) break;
            push_child(quarter, half, cell);
            if (!cells_->child_finished(child, cell)) continue;
            hide(tile, half, cells_->to[cell]);
            break;
        }
    }
}

template <class Real>
HWY_INLINE void CellTree<Real>::push_child(const Child& child, int pixels, std::size_t parent) {
    Real from = cells_->child_from[child.index][parent];
    Real to = cells_->child_to[child.index][parent];
    CellTile tile = child.tile;
    if (cells_->tile[parent].inside == 0) {
        from = std::max(from, -upper_end(Real{}, -child.depths.enter_lo));
        to = std::min(to, upper_end(Real{}, child.depths.exit_hi));
        tile.inside = static_cast<double>(from) >= child.depths.enter_hi &&
                              static_cast<double>(to) <= child.depths.exit_lo
                          ? 1
                          : 0;
    }
    if (from >= child.hidden) return;
    const Real length = to - from;
    const Real parent_length = cells_->to[parent] - cells_->from[parent];
    const Real width = child.width_by_depth * (distance_ + from);
    constexpr auto much = static_cast<Real>(0.6);
    if (!(length > width && length > much * parent_length)) return next_->push(tile, from, to);
    Real begin = from;
    if (pixels >= leaf_pixels && length > 3 * width) {
        constexpr Real part = Real{1} / most_parts;
        for (int i = 1; i < most_parts; ++i) {
            const Real end = from + length * (part * static_cast<Real>(i));
            next_->push(tile, begin, end);
            begin = end;
        }
    } else {
        begin = from + Real{0.5} * length;
        next_->push(tile, from, begin);
    }
    next_->push(tile, begin, to);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
