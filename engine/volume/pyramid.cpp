#include "engine/volume/pyramid.hpp"

#include "engine/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

namespace zeroset {
namespace {

constexpr std::int64_t brick_shift = Pyramid<float>::lowest_shift;
constexpr std::int64_t brick_cells = std::int64_t{1} << brick_shift;

/// A brick that holds no sample yet.
template <class Sample>
constexpr Sample no_lo = std::numeric_limits<Sample>::max();
template <class Sample>
constexpr Sample no_hi = std::numeric_limits<Sample>::lowest();

template <class Sample>
bool is_hole(Sample sample) {
    if constexpr (std::is_floating_point_v<Sample>) {
        return !(std::abs(sample) <= std::numeric_limits<Sample>::max());
    } else {
        return false;
    }
}

std::array<std::int64_t, 3> cells_of(const GridSize& size) {
    return {static_cast<std::int64_t>(size[0]) - 1, static_cast<std::int64_t>(size[1]) - 1,
            static_cast<std::int64_t>(size[2]) - 1};
}

}  // namespace

/// Minima and maxima of the finite samples at each place of some rows.
template <class Sample>
struct RowRange {
    std::vector<Sample> lo, hi;

    explicit RowRange(std::size_t width) : lo(width), hi(width) { clear(); }
    void clear() {
        std::ranges::fill(lo, no_lo<Sample>);
        std::ranges::fill(hi, no_hi<Sample>);
    }
    /// Whether one of the samples is no finite number. Without branches, to be done in vectors.
    bool add(std::span<const Sample> row) {
        Sample* const least = lo.data();
        Sample* const largest = hi.data();
        int holes = 0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const Sample sample = row[i];
            const bool hole = is_hole(sample);
            const bool lower = !hole & (sample < least[i]);
            const bool higher = !hole & (sample > largest[i]);
            least[i] = lower ? sample : least[i];
            largest[i] = higher ? sample : largest[i];
            holes |= hole ? 1 : 0;
        }
        return holes != 0;
    }
    void add(const RowRange& other) {
        for (std::size_t i = 0; i < lo.size(); ++i) {
            lo[i] = other.lo[i] < lo[i] ? other.lo[i] : lo[i];
            hi[i] = other.hi[i] > hi[i] ? other.hi[i] : hi[i];
        }
    }
};

template <class Sample>
Pyramid<Sample>::Pyramid(const Samples& samples) {
    make_bricks(samples);
    while (std::ranges::max(levels_.back().count) > 1)
        add_level();
}

/// Makes a row of bricks of the minima and maxima of the samples about it.
template <class Sample>
void Pyramid<Sample>::fill_row(const RowRange<Sample>& range, std::span<Brick> row) {
    const auto last = static_cast<std::int64_t>(range.lo.size()) - 1;
    for (std::size_t brick = 0; brick < row.size(); ++brick) {
        const auto from = static_cast<std::int64_t>(brick) * brick_cells;
        const std::int64_t to = std::min(from + brick_cells, last);
        Sample lo = no_lo<Sample>;
        Sample hi = no_hi<Sample>;
        for (auto i = static_cast<std::size_t>(from); i <= static_cast<std::size_t>(to); ++i) {
            lo = range.lo[i] < lo ? range.lo[i] : lo;
            hi = range.hi[i] > hi ? range.hi[i] : hi;
        }
        row[brick] = {lo, hi};
    }
}

/// Makes the bricks of a slice of the lowest level; whether a sample about it is a hole.
template <class Sample>
bool Pyramid<Sample>::make_slice(const Samples& samples, std::int64_t slice, Level& level) {
    const auto cells = cells_of(samples.size);
    const auto width = static_cast<std::size_t>(cells[0]) + 1;
    const auto* const data = static_cast<const Sample*>(samples.data.get());
    const std::int64_t first = slice * brick_cells;
    const std::int64_t last = std::min(first + brick_cells, cells[2]);
    RowRange<Sample> row(width);    // over the slices
    RowRange<Sample> brick(width);  // and over the rows of a brick
    bool holes = false;
    for (std::int64_t j = 0; j <= cells[1]; ++j) {
        row.clear();
        for (std::int64_t k = first; k <= last; ++k)
            holes |=
                row.add({data + static_cast<std::size_t>(k * (cells[1] + 1) + j) * width, width});
        brick.add(row);
        const bool ends = j > 0 && (j % brick_cells == 0 || j == cells[1]);
        if (!ends) continue;
        const std::size_t at = place(level, 0, (j - 1) / brick_cells, slice);
        fill_row(brick,
                 std::span(level.bricks).subspan(at, static_cast<std::size_t>(level.count[0])));
        // The next brick begins with this row, too.
        brick.clear();
        brick.add(row);
    }
    return holes;
}

template <class Sample>
void Pyramid<Sample>::make_bricks(const Samples& samples) {
    const auto cells = cells_of(samples.size);
    Level& level = levels_.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
        level.count[axis] = (cells[axis] + brick_cells - 1) >> brick_shift;
    level.bricks.resize(static_cast<std::size_t>(level.count[0] * level.count[1] * level.count[2]));
    std::atomic<bool> holes = false;
    parallel_for(static_cast<std::size_t>(level.count[2]), 0, [&](std::size_t slice) {
        if (make_slice(samples, static_cast<std::int64_t>(slice), level)) holes = true;
    });
    if constexpr (std::is_floating_point_v<Sample>) {
        if (holes) find_holes(samples);
    }
}

/// Marks the bricks of the lowest level with an infinite sample or a NaN.
template <class Sample>
void Pyramid<Sample>::find_holes(const Samples& samples) {
    Level& level = levels_.front();
    const auto cells = cells_of(samples.size);
    const auto* const data = static_cast<const Sample*>(samples.data.get());
    const auto slices = static_cast<std::size_t>(samples.size[2]);
    const std::uint64_t slice_size = samples.size[0] * samples.size[1];
    std::vector<std::uint8_t> found(slices);
    parallel_for(slices, 0, [&](std::size_t k) {
        const Sample* const slice = data + k * slice_size;
        found[k] = std::any_of(slice, slice + slice_size, is_hole<Sample>) ? 1 : 0;
    });
    level.holes.assign(level.bricks.size(), false);
    for (std::int64_t k = 0; k <= cells[2]; ++k) {
        if (found[static_cast<std::size_t>(k)] == 0) continue;
        for (std::int64_t j = 0; j <= cells[1]; ++j) {
            for (std::int64_t i = 0; i <= cells[0]; ++i) {
                if (is_hole(data[((k * (cells[1] + 1)) + j) * (cells[0] + 1) + i]))
                    mark_hole(level, {i, j, k});
            }
        }
    }
}

/// Marks the bricks that have this sample: those that meet in it share it.
template <class Sample>
void Pyramid<Sample>::mark_hole(Level& level, const std::array<std::int64_t, 3>& sample) {
    std::array<std::int64_t, 3> first{};
    std::array<std::int64_t, 3> last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        first[axis] = std::max<std::int64_t>(0, (sample[axis] - 1) >> brick_shift);
        last[axis] = std::min(level.count[axis] - 1, sample[axis] >> brick_shift);
    }
    for (std::int64_t z = first[2]; z <= last[2]; ++z) {
        for (std::int64_t y = first[1]; y <= last[1]; ++y) {
            for (std::int64_t x = first[0]; x <= last[0]; ++x)
                level.holes[place(level, x, y, z)] = true;
        }
    }
}

template <class Sample>
void Pyramid<Sample>::add_level() {
    const Level& below = levels_.back();
    Level level;
    for (std::size_t axis = 0; axis < 3; ++axis)
        level.count[axis] = (below.count[axis] + 1) / 2;
    const auto bricks = static_cast<std::size_t>(level.count[0] * level.count[1] * level.count[2]);
    level.bricks.assign(bricks, {no_lo<Sample>, no_hi<Sample>});
    if (!below.holes.empty()) level.holes.assign(bricks, false);
    parallel_for(static_cast<std::size_t>(level.count[2]), 0, [&](std::size_t slice) {
        const auto first = 2 * static_cast<std::int64_t>(slice);
        for (std::int64_t k = first; k < std::min(first + 2, below.count[2]); ++k) {
            for (std::int64_t j = 0; j < below.count[1]; ++j) {
                for (std::int64_t i = 0; i < below.count[0]; ++i) {
                    const Brick& from = below.bricks[place(below, i, j, k)];
                    Brick& to = level.bricks[place(level, i / 2, j / 2, k / 2)];
                    to.lo = std::min(to.lo, from.lo);
                    to.hi = std::max(to.hi, from.hi);
                }
            }
        }
    });
    for (std::size_t at = 0; at < below.holes.size(); ++at) {
        if (!below.holes[at]) continue;
        const auto width = static_cast<std::size_t>(below.count[0]);
        const auto height = static_cast<std::size_t>(below.count[1]);
        const std::array<std::size_t, 3> index{at % width, at / width % height,
                                               at / width / height};
        level.holes[place(level, static_cast<std::int64_t>(index[0] / 2),
                          static_cast<std::int64_t>(index[1] / 2),
                          static_cast<std::int64_t>(index[2] / 2))] = true;
    }
    levels_.push_back(std::move(level));
}

template <class Sample>
SampleRange Pyramid<Sample>::range(const CellSpan& cells) const {
    constexpr std::int64_t most_bricks = 36;
    std::size_t at = 0;
    CellSpan span{};
    for (;; ++at) {
        std::int64_t count = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto shift = brick_shift + static_cast<std::int64_t>(at);
            span.first[axis] = cells.first[axis] >> shift;
            span.last[axis] = cells.last[axis] >> shift;
            count *= span.last[axis] - span.first[axis] + 1;
            // Counts of large spans would leave 64 bits.
            count = std::min(count, std::int64_t{1} << 30U);
        }
        if (count <= most_bricks || at + 1 == levels_.size()) break;
    }
    const Level& level = levels_[at];
    SampleRange range;
    for (std::int64_t k = span.first[2]; k <= span.last[2]; ++k) {
        for (std::int64_t j = span.first[1]; j <= span.last[1]; ++j) {
            for (std::int64_t i = span.first[0]; i <= span.last[0]; ++i) {
                const std::size_t index = place(level, i, j, k);
                const Brick& brick = level.bricks[index];
                if (!level.holes.empty() && level.holes[index]) range.holes = true;
                if (brick.lo > brick.hi) continue;
                range.add(
                    {.lo = static_cast<double>(brick.lo), .hi = static_cast<double>(brick.hi)});
            }
        }
    }
    return range;
}

template <class Sample>
SampleRange Pyramid<Sample>::range() const {
    const std::array<std::int64_t, 3>& count = levels_.front().count;
    return range({{0, 0, 0},
                  {(count[0] << brick_shift) - 1, (count[1] << brick_shift) - 1,
                   (count[2] << brick_shift) - 1}});
}

template class Pyramid<std::int8_t>;
template class Pyramid<std::uint8_t>;
template class Pyramid<std::int16_t>;
template class Pyramid<std::uint16_t>;
template class Pyramid<std::int32_t>;
template class Pyramid<std::uint32_t>;
template class Pyramid<std::int64_t>;
template class Pyramid<std::uint64_t>;
template class Pyramid<float>;
template class Pyramid<double>;

}  // namespace zeroset
