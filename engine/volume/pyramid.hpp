#pragma once

#include "engine/volume/samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace zeroset {

/// Cells of a grid from `first` to `last` along each axis, both included. Cell i lies between the
/// samples i and i + 1.
struct CellSpan {
    std::array<std::int64_t, 3> first, last;
};

/// The least and the largest sample that is a finite number; lo > hi where none is.
struct SampleRange {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();
    bool holes = false;  ///< whether a sample is infinite or NaN

    [[nodiscard]] bool any() const { return lo <= hi; }
    void add(const SampleRange& other) {
        lo = std::min(lo, other.lo);
        hi = std::max(hi, other.hi);
        holes = holes || other.holes;
    }
};

template <class Sample>
struct RowRange;

/// The range of numbers; those that are not finite are holes.
inline SampleRange range_of(std::span<const double> numbers) {
    SampleRange range;
    for (const double number : numbers) {
        if (!(std::abs(number) <= std::numeric_limits<double>::max())) {
            range.holes = true;
            continue;
        }
        range.lo = number < range.lo ? number : range.lo;
        range.hi = number > range.hi ? number : range.hi;
    }
    return range;
}

/// Minima and maxima of the samples of bricks of 4^3 cells, of 8^3 and so on up to one brick.
/// `Sample` is the grid's own type. Immutable.
template <class Sample>
class Pyramid {
public:
    explicit Pyramid(const Samples& samples);

    /// Encloses the samples of these cells, from few bricks: those about them, too.
    [[nodiscard]] SampleRange range(const CellSpan& cells) const;
    /// The range of all samples.
    [[nodiscard]] SampleRange range() const;

    /// The least and the largest finite sample of a brick.
    struct Brick {
        Sample lo, hi;  ///< lo > hi: no finite sample
    };
    /// Bricks of level n are 1 << (lowest_shift + n) cells wide; the last level has one.
    static constexpr int lowest_shift = 2;
    [[nodiscard]] int levels() const { return static_cast<int>(levels_.size()); }
    [[nodiscard]] const Brick& brick(int level, std::int64_t i, std::int64_t j,
                                     std::int64_t k) const {
        const Level& of = levels_[static_cast<std::size_t>(level)];
        return of.bricks[place(of, i, j, k)];
    }

private:
    struct Level {
        std::array<std::int64_t, 3> count{};
        std::vector<Brick> bricks;
        std::vector<bool> holes;  ///< empty where no sample is one
    };

    void make_bricks(const Samples& samples);
    static bool make_slice(const Samples& samples, std::int64_t slice, Level& level);
    static void fill_row(const RowRange<Sample>& range, std::span<Brick> row);
    void add_level();
    void find_holes(const Samples& samples);
    static void mark_hole(Level& level, const std::array<std::int64_t, 3>& sample);
    [[nodiscard]] static std::size_t place(const Level& level, std::int64_t i, std::int64_t j,
                                           std::int64_t k) {
        return static_cast<std::size_t>((k * level.count[1] + j) * level.count[0] + i);
    }

    std::vector<Level> levels_;
};

extern template class Pyramid<std::int8_t>;
extern template class Pyramid<std::uint8_t>;
extern template class Pyramid<std::int16_t>;
extern template class Pyramid<std::uint16_t>;
extern template class Pyramid<std::int32_t>;
extern template class Pyramid<std::uint32_t>;
extern template class Pyramid<std::int64_t>;
extern template class Pyramid<std::uint64_t>;
extern template class Pyramid<float>;
extern template class Pyramid<double>;

}  // namespace zeroset
