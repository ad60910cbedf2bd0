#pragma once

#include "engine/scene/open_space.hpp"
#include "engine/trace/trace_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// An OpenSpace as a frame shows it: for each block of pixels, the slabs of depth in which the
/// surface may be. Read-only; any thread.
class OpenView {
public:
    static constexpr int block_pixels = 8;

    /// `frame`: of the surface, in a scene whose clip box is the space's.
    OpenView(const TraceFrame& frame, const OpenSpace& space);

    /// Whether the surface may be on the rays of a square of the image's pixels, a power of two of
    /// them wide and as much from its edges as that, between two depths s.
    [[nodiscard]] bool may_hold(int col, int row, int pixels, double from, double to) const {
        const Level& level = levels_[level_of(pixels)];
        const std::size_t block = static_cast<std::size_t>(row >> level.shift) * level.cols +
                                  static_cast<std::size_t>(col >> level.shift);
        return (level.slabs[block] & slabs_between(from, to)) != 0;
    }

private:
    static constexpr std::size_t level_count = 4;
    static constexpr int slab_count = 64;  ///< bits of a word
    static constexpr int first_shift = 3;  ///< 2^3 is block_pixels

    /// The image in squares of 2^shift pixels, in rows; slab i is bit i.
    struct Level {
        int shift = 0;
        std::size_t cols = 0, rows = 0;
        std::vector<std::uint64_t> slabs;
    };
    struct Seen {
        double first_col, last_col, first_row, last_row;  ///< in pixels
        double from, to;
    };

    static std::size_t level_of(int pixels) {
        return pixels >= 64 ? 3 : pixels >= 32 ? 2 : pixels >= 16 ? 1 : 0;
    }
    [[nodiscard]] int slab_at(double s) const;
    [[nodiscard]] std::uint64_t slabs_between(double from, double to) const {
        const int first = slab_at(from);
        const int last = slab_at(to);
        return ~std::uint64_t{0} >> (slab_count - 1 - last) & ~std::uint64_t{0} << first;
    }
    void begin_slabs(const TraceFrame& frame, const Box& box, double spare);
    void mark(const Seen& seen);
    void join_levels();

    double first_depth_ = 0.0;
    double slabs_per_depth_ = 0.0;
    std::array<Level, level_count> levels_;
};

}  // namespace zeroset
