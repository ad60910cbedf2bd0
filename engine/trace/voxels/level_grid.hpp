#pragma once

#include "engine/trace/voxels/block_lanes.hpp"
#include "engine/trace/voxels/ray_block.hpp"
#include "engine/trace/voxels/ray_cubic.hpp"
#include "engine/volume/volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace zeroset {

/// The layers of a slab, the least and the greatest one.
struct LayerRange {
    std::int32_t low, high;
};

/// Which cells of a slab may hold the level: a bit each.
struct CellMask {
    static constexpr int most_cells = 63;  ///< along each axis across
    static constexpr int most_layers = 4;

    CellRectangle cells{};
    LayerRange layers{};
    bool any = false;
    std::array<std::array<std::uint64_t, most_cells>, most_layers> bits{};
    std::array<bool, most_layers> layer_any{};

    /// Cells beyond its rectangle do not hold it, or no ray is in them.
    [[nodiscard]] bool may_hold(std::int32_t i, std::int32_t j, std::int32_t layer) const {
        if (i < cells.i_first || i > cells.i_last || j < cells.j_first || j > cells.j_last)
            return false;
        const auto row = static_cast<std::size_t>(j - cells.j_first);
        return (bits[static_cast<std::size_t>(layer - layers.low)][row] >> (i - cells.i_first) &
                1U) != 0;
    }
    /// Whether rays_near can be asked: the rectangle fits in NearCells.
    [[nodiscard]] bool is_small() const {
        return cells.i_last - cells.i_first < 32 && cells.j_last - cells.j_first < 64;
    }
    /// The marked cells of a layer, but for where they are.
    [[nodiscard]] NearCells near(std::int32_t layer) const {
        NearCells near;
        const auto& of = bits[static_cast<std::size_t>(layer - layers.low)];
        const auto rows = static_cast<std::size_t>(cells.j_last - cells.j_first + 1);
        for (std::size_t row = 0; row < rows; ++row) {
            std::uint64_t marks = of[row];
            for (std::size_t behind = row + 1; behind <= row + 2 && behind < rows; ++behind)
                marks |= of[behind];
            near.rows[row] = static_cast<std::uint32_t>(marks | marks >> 1U | marks >> 2U);
        }
        return near;
    }
    /// Whether cells between these places may hold it.
    [[nodiscard]] bool may_hold_between(double i_low, double i_high, double j_low, double j_high,
                                        std::int32_t layer) const {
        // Truncated to cells: from the rectangle's first one on, places are above 0.
        const std::int32_t first = std::max(static_cast<std::int32_t>(i_low - cells.i_first), 0);
        const std::int32_t last = std::min(static_cast<std::int32_t>(i_high - cells.i_first),
                                           cells.i_last - cells.i_first);
        const std::int32_t first_row =
            std::max(static_cast<std::int32_t>(j_low - cells.j_first), 0);
        const std::int32_t last_row = std::min(static_cast<std::int32_t>(j_high - cells.j_first),
                                               cells.j_last - cells.j_first);
        if (first > last) return false;
        const auto& rows = bits[static_cast<std::size_t>(layer - layers.low)];
        const std::uint64_t wanted = (std::uint64_t{2} << last) - (std::uint64_t{1} << first);
        for (std::int32_t row = first_row; row <= last_row; ++row) {
            if ((rows[static_cast<std::size_t>(row)] & wanted) != 0) return true;
        }
        return false;
    }
};

/// A grid of samples and a level: where a trilinear function comes nearer to it than `error`.
/// Samples are float, or whole numbers that are exact in float.
template <class Sample>
class LevelGrid {
public:
    LevelGrid(const VolumeData& data, const Sample* samples, double level, double error)
        : pyramid_(data.pyramid<Sample>()), samples_(samples), level_(level) {
        const auto& size = data.samples().size;
        strides_ = {1, static_cast<std::ptrdiff_t>(size[0]),
                    static_cast<std::ptrdiff_t>(size[0] * size[1])};
        above_ = outward(level + error, std::numeric_limits<float>::infinity());
        below_ = outward(level - error, -std::numeric_limits<float>::infinity());
    }

    [[nodiscard]] int top_level() const { return pyramid_.levels() - 1; }
    static constexpr int lowest_shift = Pyramid<Sample>::lowest_shift;

    /// Whether one of the bricks of a level of the pyramid that these cells are in may hold the
    /// level; also where they are in more than some bricks.
    [[nodiscard]] bool bricks_may_hold(int level, const CellRectangle& cells, std::int32_t layer,
                                       const WalkAxes& axes) const;
    /// The part of a slab's cells whose bricks of the lowest level may hold the level.
    [[nodiscard]] CellRectangle in_bricks(const CellRectangle& cells, std::int32_t layer,
                                          const WalkAxes& axes) const;
    /// Finds the cells of a slab that may hold the level. At most CellMask's numbers of cells.
    void find(const CellRectangle& cells, const LayerRange& layers, const WalkAxes& axes,
              CellMask& mask) const;
    /// The corners of a cell, less the level, in the order of the grid's own axes.
    [[nodiscard]] CellCorners corners(const std::array<std::int32_t, 3>& cell) const {
        const Sample* const base =
            samples_ + cell[0] * strides_[0] + cell[1] * strides_[1] + cell[2] * strides_[2];
        CellCorners corners{};
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::ptrdiff_t at = ((corner & 1U) != 0 ? strides_[0] : 0) +
                                      ((corner & 2U) != 0 ? strides_[1] : 0) +
                                      ((corner & 4U) != 0 ? strides_[2] : 0);
            corners[corner] = static_cast<double>(base[at]) - level_;
        }
        return corners;
    }

private:
    /// Calls `take(i, j)` for the bricks of a level that these cells are in and that may hold the
    /// level, until it returns false.
    template <class Take>
    void visit_bricks(int level, const CellRectangle& cells, std::int32_t layer,
                      const WalkAxes& axes, const Take& take) const;
    /// The next float in a direction, unless the number is one.
    static float outward(double number, float towards) {
        const auto nearest = static_cast<float>(number);
        const bool beyond = towards > 0 ? static_cast<double>(nearest) >= number
                                        : static_cast<double>(nearest) <= number;
        return beyond ? nearest : std::nextafter(nearest, towards);
    }
    /// A rectangle of samples, across two axes.
    struct Patch {
        const Sample* first;
        std::ptrdiff_t i_stride, j_stride;
        std::size_t count, rows;  ///< along both
    };
    using PatchBits = std::array<SampleBits, CellMask::most_cells + 1>;
    void find_bits(const Patch& patch, PatchBits& bits) const;

    const Pyramid<Sample>& pyramid_;
    const Sample* samples_;
    double level_;
    float above_ = 0, below_ = 0;
    std::array<std::ptrdiff_t, 3> strides_{};
};

template <class Sample>
template <class Take>
void LevelGrid<Sample>::visit_bricks(int level, const CellRectangle& cells, std::int32_t layer,
                                     const WalkAxes& axes, const Take& take) const {
    const int shift = lowest_shift + level;
    std::array<std::int32_t, 3> at{};
    at[axes.k] = layer >> shift;
    for (std::int32_t j = cells.j_first >> shift; j <= cells.j_last >> shift; ++j) {
        for (std::int32_t i = cells.i_first >> shift; i <= cells.i_last >> shift; ++i) {
            at[axes.i] = i;
            at[axes.j] = j;
            const auto& brick = pyramid_.brick(level, at[0], at[1], at[2]);
            const bool may_hold =
                (static_cast<float>(brick.lo) < above_) && (static_cast<float>(brick.hi) > below_);
            if (may_hold && !take(i, j)) return;
        }
    }
}

template <class Sample>
bool LevelGrid<Sample>::bricks_may_hold(int level, const CellRectangle& cells, std::int32_t layer,
                                        const WalkAxes& axes) const {
    constexpr std::int32_t most_bricks = 16;
    const int shift = lowest_shift + level;
    const std::int32_t cols = (cells.i_last >> shift) - (cells.i_first >> shift) + 1;
    const std::int32_t rows = (cells.j_last >> shift) - (cells.j_first >> shift) + 1;
    if (cols > most_bricks || rows > most_bricks || cols * rows > most_bricks) return true;
    bool any = false;
    visit_bricks(level, cells, layer, axes, [&any](std::int32_t, std::int32_t) {
        any = true;
        return false;
    });
    return any;
}

template <class Sample>
CellRectangle LevelGrid<Sample>::in_bricks(const CellRectangle& cells, std::int32_t layer,
                                           const WalkAxes& axes) const {
    CellRectangle held{.i_first = cells.i_last + 1,
                       .i_last = cells.i_first - 1,
                       .j_first = cells.j_last + 1,
                       .j_last = cells.j_first - 1};
    visit_bricks(0, cells, layer, axes, [&](std::int32_t i, std::int32_t j) {
        const std::int32_t i_low = i << lowest_shift;
        const std::int32_t j_low = j << lowest_shift;
        constexpr std::int32_t width = std::int32_t{1} << lowest_shift;
        held.i_first = std::min(held.i_first, std::max(i_low, cells.i_first));
        held.i_last = std::max(held.i_last, std::min(i_low + width - 1, cells.i_last));
        held.j_first = std::min(held.j_first, std::max(j_low, cells.j_first));
        held.j_last = std::max(held.j_last, std::min(j_low + width - 1, cells.j_last));
        return true;
    });
    return held;
}

template <class Sample>
void LevelGrid<Sample>::find_bits(const Patch& patch, PatchBits& bits) const {
    if constexpr (std::is_same_v<Sample, float>) {
        if (patch.i_stride == 1) {
            return sample_bits(patch.first, patch.j_stride, patch.rows, patch.count, above_, below_,
                               bits.data());
        }
    }
    std::array<float, CellMask::most_cells + 1> samples;
    for (std::size_t row = 0; row < patch.rows; ++row) {
        const Sample* const from = patch.first + static_cast<std::ptrdiff_t>(row) * patch.j_stride;
        for (std::size_t i = 0; i < patch.count; ++i)
            samples[i] = static_cast<float>(from[static_cast<std::ptrdiff_t>(i) * patch.i_stride]);
        sample_bits(samples.data(), 0, 1, patch.count, above_, below_, &bits[row]);
    }
}

template <class Sample>
void LevelGrid<Sample>::find(const CellRectangle& cells, const LayerRange& layers,
                             const WalkAxes& axes, CellMask& mask) const {
    mask.cells = cells;
    mask.layers = layers;
    mask.any = false;
    Patch patch{.first = samples_ + cells.i_first * strides_[axes.i] +
                         cells.j_first * strides_[axes.j] + layers.low * strides_[axes.k],
                .i_stride = strides_[axes.i],
                .j_stride = strides_[axes.j],
                .count = static_cast<std::size_t>(cells.i_last - cells.i_first + 2),
                .rows = static_cast<std::size_t>(cells.j_last - cells.j_first + 2)};
    const std::uint64_t valid = (std::uint64_t{1} << (patch.count - 1)) - 1;
    // All four samples of a cell's face across the axis, of this layer's side and of the next one
    std::array<PatchBits, 2> faces;
    for (int side = 0; side <= layers.high - layers.low + 1; ++side) {
        PatchBits& face = faces[static_cast<std::size_t>(side & 1)];
        find_bits(patch, face);
        patch.first += strides_[axes.k];
        for (std::size_t row = 0; row + 1 < patch.rows; ++row) {
            const std::uint64_t above = face[row].above & face[row + 1].above;
            const std::uint64_t below = face[row].below & face[row + 1].below;
            face[row] = {.above = above & above >> 1U, .below = below & below >> 1U};
        }
        if (side == 0) continue;
        const auto layer = static_cast<std::size_t>(side - 1);
        std::uint64_t any = 0;
        for (std::size_t row = 0; row + 1 < patch.rows; ++row) {
            const std::uint64_t free = (faces[0][row].above & faces[1][row].above) |
                                       (faces[0][row].below & faces[1][row].below);
            mask.bits[layer][row] = ~free & valid;
            any |= mask.bits[layer][row];
        }
        mask.layer_any[layer] = any != 0;
        mask.any = mask.any || any != 0;
    }
}

}  // namespace zeroset
