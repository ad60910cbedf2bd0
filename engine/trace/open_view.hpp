#pragma once

#include "engine/scene/open_space.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// An OpenSpace as a frame shows it: for each tile of the image, the slabs of depth in which the
/// surface may be. Read-only; any thread.
class OpenView {
public:
    /// `frame`: of the surface, in a scene whose clip box is the space's.
    OpenView(const TraceFrame& frame, const OpenSpace& space);

    /// Whether the surface may be on the rays of the tile of the image that begins at a pixel,
    /// between two depths s.
    [[nodiscard]] bool may_hold(int col, int row, double from, double to) const {
        const std::size_t tile = static_cast<std::size_t>(row / tile_size) * cols_ +
                                 static_cast<std::size_t>(col / tile_size);
        return (slabs_[tile] & slabs_between(from, to)) != 0;
    }

private:
    static constexpr int slab_count = 64;  ///< bits of a word

    struct Seen {
        double first_col, last_col, first_row, last_row;  ///< in pixels
        double from, to;
    };

    [[nodiscard]] int slab_at(double s) const;
    [[nodiscard]] std::uint64_t slabs_between(double from, double to) const {
        const int first = slab_at(from);
        const int last = slab_at(to);
        return ~std::uint64_t{0} >> (slab_count - 1 - last) & ~std::uint64_t{0} << first;
    }
    void begin_slabs(const TraceFrame& frame, const Box& box, double spare);
    void mark(const Seen& seen);

    double first_depth_ = 0.0;
    double slabs_per_depth_ = 0.0;
    std::size_t cols_, rows_;           ///< tiles
    std::vector<std::uint64_t> slabs_;  ///< of each tile, in rows; slab i is bit i
};

}  // namespace zeroset
