#include "engine/volume/pyramid.hpp"

#include "engine/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <type_traits>

namespace zeroset {
namespace {

constexpr std::int64_t brick_shift = 2;  ///< bricks of the lowest level are 4 cells wide
constexpr std::int64_t brick_cells = std::int64_t{1} << brick_shift;

/// A brick that holds no sample yet.
template <class Sample>
constexpr Sample no_lo = std::numeric_limits<Sample>::max();
template <class Sample>
constexpr Sample no_hi = std::numeric_limits<Sample>::lowest();

template <class Sample>
bool is_hole(Sample sample) {
    if constexpr (std::is_floating_point_v<Sample>) {
        return !std::isfinite(sample);
    } else {
        return false;
    }
}

std::array<std::int64_t, 3> cells_of(const GridSize& size) {
    return {static_cast<std::int64_t>(size[0]) - 1, static_cast<std::int64_t>(size[1]) - 1,
            static_cast<std::int64_t>(size[2]) - 1};
}

}  // namespace

template <class Sample>
std::size_t Pyramid<Sample>::place(const Level& level, std::int64_t i, std::int64_t j,
                                   std::int64_t k) {
    return static_cast<std::size_t>((k * level.count[1] + j) * level.count[0] + i);
}

template <class Sample>
Pyramid<Sample>::Pyramid(const Samples& samples) {
    make_bricks(samples);
    while (std::ranges::max(levels_.back().count) > 1)
        add_level();
}

/// Adds the samples of row (j, k) to a row of bricks.
template <class Sample>
void Pyramid<Sample>::add_rows(const Samples& samples, std::int64_t k, std::int64_t j,
                               std::vector<Brick>& row) const {
    const auto width = static_cast<std::int64_t>(samples.size[0]);
    const auto height = static_cast<std::int64_t>(samples.size[1]);
    const Sample* const line =
        static_cast<const Sample*>(samples.data.get()) + (k * height + j) * width;
    for (std::size_t brick = 0; brick < row.size(); ++brick) {
        const auto from = static_cast<std::int64_t>(brick) * brick_cells;
        const std::int64_t to = std::min(from + brick_cells, width - 1);
        Sample lo = row[brick].lo;
        Sample hi = row[brick].hi;
        for (std::int64_t i = from; i <= to; ++i) {
            const Sample sample = line[i];
            if (is_hole(sample)) continue;
            lo = sample < lo ? sample : lo;
            hi = sample > hi ? sample : hi;
        }
        row[brick] = {lo, hi};
    }
}

template <class Sample>
void Pyramid<Sample>::make_bricks(const Samples& samples) {
    const auto cells = cells_of(samples.size);
    Level& level = levels_.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
        level.count[axis] = (cells[axis] + brick_cells - 1) >> brick_shift;
    level.bricks.resize(static_cast<std::size_t>(level.count[0] * level.count[1] * level.count[2]));
    parallel_for(static_cast<std::size_t>(level.count[2]), 0, [&](std::size_t slice) {
        const auto z = static_cast<std::int64_t>(slice);
        std::vector<Brick> row(static_cast<std::size_t>(level.count[0]));
        for (std::int64_t y = 0; y < level.count[1]; ++y) {
            std::ranges::fill(row, Brick{no_lo<Sample>, no_hi<Sample>});
            for (std::int64_t k = z * brick_cells; k <= std::min((z + 1) * brick_cells, cells[2]);
                 ++k) {
                for (std::int64_t j = y * brick_cells;
                     j <= std::min((y + 1) * brick_cells, cells[1]); ++j)
                    add_rows(samples, k, j, row);
            }
            std::ranges::copy(
                row, level.bricks.begin() + static_cast<std::ptrdiff_t>(place(level, 0, y, z)));
        }
    });
    if constexpr (std::is_floating_point_v<Sample>) find_holes(samples);
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
    if (std::ranges::none_of(found, [](std::uint8_t any) { return any != 0; })) return;
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
    for (std::int64_t k = 0; k < below.count[2]; ++k) {
        for (std::int64_t j = 0; j < below.count[1]; ++j) {
            for (std::int64_t i = 0; i < below.count[0]; ++i) {
                const std::size_t from = place(below, i, j, k);
                const std::size_t to = place(level, i / 2, j / 2, k / 2);
                level.bricks[to].lo = std::min(level.bricks[to].lo, below.bricks[from].lo);
                level.bricks[to].hi = std::max(level.bricks[to].hi, below.bricks[from].hi);
                if (!below.holes.empty() && below.holes[from]) level.holes[to] = true;
            }
        }
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
