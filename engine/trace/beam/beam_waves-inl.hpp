// Tiles of pixels whose cells are divided from the front, some at a time.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_BEAM_WAVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_BEAM_WAVES_INL
#undef ZEROSET_BEAM_WAVES_INL
#else
#define ZEROSET_BEAM_WAVES_INL
#endif

#include "engine/trace/beam/beam_roots-inl.hpp"
#include "engine/trace/beam/beam_tree-inl.hpp"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Tiles of `pixels` x `pixels` pixels with cells that wait to be divided.
template <class Real, int pixels>
class WaitingTiles {
public:
    [[nodiscard]] bool empty() const { return waiting_.empty(); }
    /// Some of a tile's cells that may hold roots, front to back, and the kernel of f in them.
    void push(CellTile tile, const Kernel* kernel, std::span<const std::size_t> cells) {
        const std::size_t begin = cells_.size();
        cells_.insert(cells_.end(), cells.begin(), cells.end());
        waiting_.push_back({tile.pixel, kernel, begin, cells_.size()});
    }
    /// Visits the cells that wait.
    void for_each(auto visit) const {
        for (const Waiting& cells : waiting_) {
            for (std::size_t i = cells.next; i < cells.end; ++i)
                visit(cells_[i]);
        }
    }
    /// Divides the first cells of each tile; quarters all of whose roots found so far are nearer
    /// are left out.
    void divide_some(CellTree<Real>& tree, const NearestRoots<Real>& nearest) {
        first_.clear();
        std::bitset<tile_pixels> seen;
        for (std::size_t i = 0; i < waiting_.size(); ++i) {
            if (!seen[waiting_[i].tile]) first_.push_back(i);
            seen.set(waiting_[i].tile);
        }
        const std::size_t most = 1 + cells_a_wave / first_.size();
        for (const std::size_t i : first_) {
            Waiting& cells = waiting_[i];
            const std::size_t count = std::min(most, cells.end - cells.next);
            const std::size_t first = std::exchange(cells.next, cells.next + count);
            tree.push_children(cells.kernel, std::span(cells_).subspan(first, count), pixels,
                               [&](int col, int row) { return farthest(nearest, col, row); });
        }
        std::erase_if(waiting_, [](const Waiting& cells) { return cells.next == cells.end; });
    }

private:
    static constexpr std::size_t cells_a_wave = 16;  ///< at least

    struct Waiting {
        std::uint16_t tile;  ///< its first pixel
        const Kernel* kernel;
        std::size_t next, end;  ///< in cells_
    };

    /// The farthest root found of a quarter's pixels; +inf: not all have one.
    static Real farthest(const NearestRoots<Real>& nearest, int col, int row) {
        constexpr int half = pixels / 2;
        constexpr hn::CappedTag<Real, static_cast<std::size_t>(half)> tag;
        auto result = hn::Set(tag, -std::numeric_limits<Real>::infinity());
        for (int y = row; y < row + half; ++y) {
            for (int x = col; x < col + half; x += static_cast<int>(hn::Lanes(tag))) {
                const auto pixel = static_cast<std::size_t>(y * tile_size + x);
                result = hn::Max(result, hn::LoadU(tag, &nearest.s[pixel]));
            }
        }
        return hn::GetLane(hn::MaxOfLanes(tag, result));
    }

    std::vector<Waiting> waiting_;
    std::vector<std::size_t> first_;  ///< in waiting_, of each tile
    std::vector<std::size_t> cells_;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
