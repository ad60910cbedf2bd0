#pragma once

#include "engine/trace/voxels/ray_block.hpp"
#include "engine/trace/voxels/ray_cubic.hpp"
#include "engine/volume/volume.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

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

    /// Cells beyond its rectangle may hold it.
    [[nodiscard]] bool may_hold(std::int32_t i, std::int32_t j, std::int32_t layer) const {
        if (i < cells.i_first || i > cells.i_last || j < cells.j_first || j > cells.j_last)
            return true;
        const auto row = static_cast<std::size_t>(j - cells.j_first);
        return (bits[static_cast<std::size_t>(layer - layers.low)][row] >> (i - cells.i_first) &
                1U) != 0;
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
    /// Finds the cells of a slab that may hold the level. At most CellMask's numbers of cells.
    void find(const CellRectangle& cells, const LayerRange& layers, const WalkAxes& axes,
              CellMask& mask) const;
    /// The corners of a cell, less the level, in the order of the grid's own axes.
    [[nodiscard]] CellCorners corners(const std::array<std::int32_t, 3>& cell) const {
        const Sample* const base = samples_ + cell[0] * strides_[0] + cell[1] * strides_[1] +
                                   cell[2] * strides_[2];
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
    /// The samples of a row that are above the level for sure, and those that are below it.
    struct RowBits {
        std::uint64_t above, below;
    };

    /// The next float in a direction, unless the number is one.
    static float outward(double number, float towards) {
        const auto nearest = static_cast<float>(number);
        const bool beyond = towards > 0 ? static_cast<double>(nearest) >= number
                                        : static_cast<double>(nearest) <= number;
        return beyond ? nearest : std::nextafter(nearest, towards);
    }
    [[nodiscard]] RowBits row_bits(const Sample* row, std::ptrdiff_t stride, int count) const {
        RowBits bits{};
        for (int i = 0; i < count; ++i) {
            const auto sample = static_cast<float>(row[i * stride]);
            bits.above |= static_cast<std::uint64_t>(sample >= above_) << i;
            bits.below |= static_cast<std::uint64_t>(sample <= below_) << i;
        }
        return bits;
    }

    const Pyramid<Sample>& pyramid_;
    const Sample* samples_;
    double level_;
    float above_ = 0, below_ = 0;
    std::array<std::ptrdiff_t, 3> strides_{};
};

template <class Sample>
bool LevelGrid<Sample>::bricks_may_hold(int level, const CellRectangle& cells, std::int32_t layer,
                                        const WalkAxes& axes) const {
    constexpr std::int32_t most_bricks = 16;
    const int shift = lowest_shift + level;
    const std::int32_t i_last = cells.i_last >> shift;
    const std::int32_t j_last = cells.j_last >> shift;
    const std::int32_t i_first = cells.i_first >> shift;
    const std::int32_t j_first = cells.j_first >> shift;
    if ((i_last - i_first + 1) * (j_last - j_first + 1) > most_bricks) return true;
    std::array<std::int32_t, 3> at{};
    at[axes.k] = layer >> shift;
    for (std::int32_t j = j_first; j <= j_last; ++j) {
        for (std::int32_t i = i_first; i <= i_last; ++i) {
            at[axes.i] = i;
            at[axes.j] = j;
            const auto& brick = pyramid_.brick(level, at[0], at[1], at[2]);
            if (static_cast<float>(brick.lo) < above_ && static_cast<float>(brick.hi) > below_)
                return true;
        }
    }
    return false;
}

template <class Sample>
void LevelGrid<Sample>::find(const CellRectangle& cells, const LayerRange& layers,
                             const WalkAxes& axes, CellMask& mask) const {
    mask.cells = cells;
    mask.layers = layers;
    mask.any = false;
    const int rows = cells.j_last - cells.j_first + 2;
    const int count = cells.i_last - cells.i_first + 2;
    const std::uint64_t valid = (std::uint64_t{1} << (count - 1)) - 1;
    const Sample* const first = samples_ + cells.i_first * strides_[axes.i] +
                                cells.j_first * strides_[axes.j] + layers.low * strides_[axes.k];
    // All four samples of a cell's face across the axis, of this layer's side and of the next one
    std::array<std::array<RowBits, CellMask::most_cells>, 2> faces;
    for (int side = 0; side <= layers.high - layers.low + 1; ++side) {
        auto& face = faces[static_cast<std::size_t>(side & 1)];
        const Sample* const slice = first + side * strides_[axes.k];
        RowBits before{};
        for (int row = 0; row < rows; ++row) {
            RowBits bits = row_bits(slice + row * strides_[axes.j], strides_[axes.i], count);
            bits.above &= bits.above >> 1U;
            bits.below &= bits.below >> 1U;
            if (row > 0) {
                face[static_cast<std::size_t>(row - 1)] = {.above = bits.above & before.above,
                                                           .below = bits.below & before.below};
            }
            before = bits;
        }
        if (side == 0) continue;
        const auto layer = static_cast<std::size_t>(side - 1);
        std::uint64_t any = 0;
        for (std::size_t row = 0; row + 1 < static_cast<std::size_t>(rows); ++row) {
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
