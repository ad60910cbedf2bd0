// The cells of a tile, from the first ones down to the smallest. Where they begin:
// beam_tree_first-inl.hpp; what is said of them: beam_tree_judge-inl.hpp.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_TREE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_TREE_INL
#undef ZEROSET_BEAM_TREE_INL
#else
#define ZEROSET_BEAM_TREE_INL
#endif

#include "engine/trace/beam/beam_pieces-inl.hpp"
#include "engine/trace/beam/beam_ranges-inl.hpp"
#include "engine/trace/open_view.hpp"
#include "engine/trace/tile_costs.hpp"

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
/// Cells of so many neighbouring slabs of a tile share a specialized kernel.
constexpr std::size_t slabs_a_kernel = 4;

/// Memory for cells, piece by piece.
template <class Real>
struct PieceMemory {
    Pieces<Real> pieces;
    Cells<Real> cells;  ///< as many as there are pieces
    /// Where in a cell a root may be in some piece, for each quarter of its tile.
    struct Left {
        bool any = false;
        std::array<Real, 4> from, to;
    };
    std::vector<Left> left;  ///< of each cell of a list
};

/// Memory that a CellTree keeps from tile to tile.
template <class Real>
struct TreeMemory {
    Cells<Real> cells[2];
    CellKernels kernels;
    PieceMemory<Real> pieces;
    RangeMemory<Real> ranges;
    std::vector<std::size_t> asked;
    /// Depths beyond which nothing is looked for, of each of the smallest tiles, in rows.
    std::array<Real, least_tiles * least_tiles> hidden;
};

/// Cells of one size after the other: what kernels say of them, and those of the next size.
template <class Real>
class CellTree {
public:
    CellTree(const TraceFrame& frame, const Tile& tile, const TileRays& rays,
             TreeMemory<Real>& memory, Counters& counters)
        : frame_(frame),
          tile_(tile),
          rays_(rays),
          counters_(counters),
          cells_(&memory.cells[0]),
          next_(&memory.cells[1]),
          kernels_(memory.kernels),
          pieces_(memory.pieces),
          asked_(memory.asked),
          hidden_(memory.hidden),
          ranges_(frame, rays, memory.ranges, counters),
          distance_(static_cast<Real>(rays.distance())) {
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
    /// The kernel of f in some cells of the run, or in one.
    const Kernel* kernel_of(const CellRun& run, std::span<const std::size_t> cells) {
        return kernels_.specialized(run, cells);
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
    /// Tells who asks that each of some cells, tiles of this size, was evaluated.
    void tell_costs(std::span<const CellTile> tiles, int pixels) const {
        if (counters_.costs == nullptr) return;
        for (const CellTile tile : tiles)
            counters_.costs->add(tile.col(), tile.row(), pixels, pixels);
    }
    /// The first cells of one tile: `kernel` between depths, in so many slabs.
    struct First {
        const Kernel* kernel;
        int col, row;
        double from, to;
        int slabs;
    };
    void push_first(const First& first, const DepthRange& depths);
    /// A rectangle of tiles of one size: indices of its first and last columns and rows.
    struct Tiles {
        int first_col, last_col, first_row, last_row;

        [[nodiscard]] int count() const {
            return (last_col - first_col + 1) * (last_row - first_row + 1);
        }
    };
    /// The tiles that the part may be in.
    [[nodiscard]] Tiles tiles_of(const UnionMember& part, int pixels) const;
    /// The smallest tiles of which few cover the part: with these it begins.
    [[nodiscard]] int first_pixels(const UnionMember& part) const;
    void push_part(const UnionMember& part, int pixels);
    /// Narrows cells in which switches are open to what the pieces of f leave.
    void narrow_by_pieces(const CellRun& run, const FrustumOf<Real>& frustum, int pixels);
    /// Asks natural interval extensions about cells on which f is not known to be continuous or its
    /// form says nothing: they are sharper beside poles and jumps, and where numbers overflow. They
    /// tell where f is 0 in the whole cell, too.
    void reject_by_ranges(const CellRun& run, int pixels);
    HWY_INLINE void push_child(const Child& child, int pixels, std::size_t parent);
    void hide(CellTile tile, int pixels, Real to);

    [[nodiscard]] DepthRange depths_of(int col, int row, int pixels) const {
        const double half = TileRays::middle_of(pixels);
        const double radius = rays_.radius_of(pixels) * rays_.pixel();
        return rays_.depths(rays_.u(col + half), rays_.v(row + half), radius, radius);
    }
    /// The part by which cells are longer than their slabs: from size to size a little less, so
    /// that they lie in those that their kernels were specialized for.
    [[nodiscard]] Real margin_of(int pixels) const {
        return margin_ *
               static_cast<Real>(0.75 + 0.25 * std::bit_width(static_cast<unsigned>(pixels)));
    }

    const TraceFrame& frame_;
    const Tile& tile_;
    const TileRays& rays_;
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
    depths_ = depths_of(0, 0, tile_size);
    s_most_ = std::max(std::abs(depths_.enter_lo), std::abs(depths_.exit_hi)) * (1.0 + 0x1p-10);
    depths_.exit_hi = std::min(depths_.exit_hi, rays_.limit());
    // A tile is left out as a whole or not at all: what is found in it must not depend on what was
    // known of parts of it.
    if (frame_.open != nullptr && tile_.places == nullptr &&
        !frame_.open->may_hold(tile_.col, tile_.row, depths_.enter_lo, depths_.exit_hi))
        depths_.exit_hi = -std::numeric_limits<double>::infinity();
    const auto unit = static_cast<double>(std::numeric_limits<Real>::epsilon());
    const double finest = std::max(rays_.tolerance(), 8 * s_most_ * unit);
    margin_ = static_cast<Real>(2 * finest);
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
    const auto width_by_depth = static_cast<Real>(2 * rays_.pixel() * half);
    const CellTile parent = cells_->tile[open.front()];
    next_->runs.begin(kernel, next_->size);
    next_->reserve(4 * most_parts * open.size());
    const bool all_inside =
        std::ranges::all_of(open, [&](std::size_t cell) { return cells_->tile[cell].inside != 0; });
    for (std::size_t child = 0; child < 4; ++child) {
        const int col = parent.col() + ((child & 1U) != 0 ? half : 0);
        const int row = parent.row() + ((child & 2U) != 0 ? half : 0);
        if (col >= tile_.cols || row >= tile_.rows) continue;
        const Real limit = farthest(col, row);
        const CellTile tile = CellTile::at(col, row, true);
        const DepthRange depths = all_inside ? DepthRange{} : depths_of(col, row, half);
        const Child quarter{.tile = tile,
                            .index = child,
                            .depths = depths,
                            .hidden = hidden_from(tile, half),
                            .width_by_depth = width_by_depth};
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
    // Leave hidden slabs; push short ones, and those that contract well, as they are.
    if (from >= child.hidden) return;
    const Real length = to - from;
    const Real parent_length = cells_->to[parent] - cells_->from[parent];
    const Real width = child.width_by_depth * (distance_ + from);
    constexpr auto much = static_cast<Real>(0.6);
    if (!(length > width && length > much * parent_length)) return next_->push(tile, from, to);
    // Cut the others in four parts, or halves.
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
