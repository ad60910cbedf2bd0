#pragma once

#include "engine/trace/voxels/cell_mask.hpp"
#include "engine/trace/voxels/ray_block.hpp"
#include "engine/trace/voxels/spline_ray.hpp"
#include "engine/volume/volume.hpp"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace zeroset {

/// A grid of samples and a level: where a trilinear function, or a cubic spline of which they are
/// the coefficients, comes nearer to it than `error`. In a cell it lies between the `support`^3
/// samples from the cell's first one on. Samples are float, or whole numbers that are exact in
/// float.
template <class Sample, std::size_t support>
class LevelGrid {
public:
    /// `pyramid` is over these samples, `size` of them along each axis.
    LevelGrid(const Pyramid<Sample>& pyramid, const GridSize& size, const Sample* samples,
              double level, double error)
        : pyramid_(pyramid), samples_(samples), level_(level), error_(error) {
        strides_ = {1, static_cast<std::ptrdiff_t>(size[0]),
                    static_cast<std::ptrdiff_t>(size[0] * size[1])};
        bounds_ = {.level = static_cast<float>(level),
                   .above = outward(level + error, std::numeric_limits<float>::infinity()),
                   .below = outward(level - error, -std::numeric_limits<float>::infinity())};
    }

    [[nodiscard]] int top_level() const { return pyramid_.levels() - 1; }
    static constexpr int lowest_shift = Pyramid<Sample>::lowest_shift;

    /// Whether one of the bricks of a level of the pyramid that the numbers of these cells are in
    /// may hold the level; also where they are in more than some bricks.
    [[nodiscard]] bool bricks_may_hold(int level, const CellRectangle& cells,
                                       const LayerRange& layers, const WalkAxes& axes) const;
    /// The part of a slab's cells whose bricks of the lowest level may hold the level.
    [[nodiscard]] CellRectangle in_bricks(const CellRectangle& cells, const LayerRange& layers,
                                          const WalkAxes& axes) const;
    /// Begins with a slab. At most CellMask's numbers of cells.
    void begin(const CellRectangle& cells, const LayerRange& layers, const WalkAxes& axes,
               CellMask& mask) const;
    /// Finds the cells of a layer of the slab that may hold the level; those beyond the rays' reach
    /// do not count.
    void mark(std::int32_t layer, const RayReach& reach, const WalkAxes& axes,
              CellMask& mask) const;
    /// The numbers about a cell, less the level, in the order of the grid's own axes.
    [[nodiscard]] CellNumbers<support> numbers(const std::array<std::int32_t, 3>& cell) const {
        const Sample* const base =
            samples_ + cell[0] * strides_[0] + cell[1] * strides_[1] + cell[2] * strides_[2];
        CellNumbers<support> numbers{};
        std::size_t n = 0;
        for (std::size_t k = 0; k < support; ++k) {
            for (std::size_t j = 0; j < support; ++j) {
                const Sample* const row = base + static_cast<std::ptrdiff_t>(j) * strides_[1] +
                                          static_cast<std::ptrdiff_t>(k) * strides_[2];
                for (std::size_t i = 0; i < support; ++i)
                    numbers[n++] = static_cast<double>(row[i]) - level_;
            }
        }
        return numbers;
    }

private:
    /// Calls `take(i, j)` for the bricks of a level that these cells are in and that may hold the
    /// level, until it returns false.
    template <class Take>
    void visit_bricks(int level, const CellRectangle& cells, const LayerRange& layers,
                      const WalkAxes& axes, const Take& take) const;
    /// The numbers about a cell along an axis beyond the two of the pyramid's cells.
    static constexpr std::int32_t beyond = static_cast<std::int32_t>(support) - 2;
    /// The next float in a direction, unless the number is one.
    static float outward(double number, float towards) {
        const auto nearest = static_cast<float>(number);
        const bool passed = towards > 0 ? static_cast<double>(nearest) >= number
                                        : static_cast<double>(nearest) <= number;
        return passed ? nearest : std::nextafter(nearest, towards);
    }
    /// A rectangle of samples, across two axes.
    struct Patch {
        const Sample* first;
        std::ptrdiff_t i_stride, j_stride;
        std::size_t count, rows;  ///< along both
    };
    /// The samples about some cells of a layer, on its lower side.
    [[nodiscard]] Patch patch_of(const CellRectangle& cells, std::int32_t layer,
                                 const WalkAxes& axes) const {
        return {.first = samples_ + cells.i_first * strides_[axes.i] +
                         cells.j_first * strides_[axes.j] + layer * strides_[axes.k],
                .i_stride = strides_[axes.i],
                .j_stride = strides_[axes.j],
                .count = static_cast<std::size_t>(cells.i_last - cells.i_first) + support,
                .rows = static_cast<std::size_t>(cells.j_last - cells.j_first) + support};
    }
    /// Copies a slab's samples.
    static void copy(const Patch& patch, std::ptrdiff_t k_stride, std::size_t slices,
                     SlabSamples& slab);
    static bool is_row(const Patch& patch) {
        return std::is_same_v<Sample, float> && patch.i_stride == 1;
    }
    /// The bits of rows of a slice of samples, which `slab` takes from the patch, or has copied.
    void take(const Patch& patch, std::size_t slice, const SlabRows& rows, SlabSamples& slab,
              CellMask::FaceBits& bits) const {
        if constexpr (std::is_same_v<Sample, float>) {
            if (is_row(patch)) {
                return take_slice(patch.first, patch.j_stride, bounds_, slice, rows, slab,
                                  bits.data());
            }
        }
        take_slice(slab.row_at(slice, 0), static_cast<std::ptrdiff_t>(slab.row), bounds_, slice,
                   rows, slab, bits.data());
    }
    void find_bits(const Patch& patch, CellMask::FaceBits& bits) const;
    void find_face(std::size_t slice, const RayReach& reach, const WalkAxes& axes,
                   CellMask& mask) const;
    static void copy_row(const Patch& patch, std::size_t row, float* to) {
        const Sample* const from = patch.first + static_cast<std::ptrdiff_t>(row) * patch.j_stride;
        for (std::size_t i = 0; i < patch.count; ++i)
            to[i] = static_cast<float>(from[static_cast<std::ptrdiff_t>(i) * patch.i_stride]);
    }

    const Pyramid<Sample>& pyramid_;
    const Sample* samples_;
    double level_, error_;
    LevelBounds bounds_{};
    std::array<std::ptrdiff_t, 3> strides_{};
};

template <class Sample, std::size_t support>
template <class Take>
void LevelGrid<Sample, support>::visit_bricks(int level, const CellRectangle& cells,
                                              const LayerRange& layers, const WalkAxes& axes,
                                              const Take& take) const {
    const int shift = lowest_shift + level;
    std::array<std::int32_t, 3> at{};
    for (std::int32_t k = layers.low >> shift; k <= (layers.high + beyond) >> shift; ++k) {
        for (std::int32_t j = cells.j_first >> shift; j <= (cells.j_last + beyond) >> shift; ++j) {
            for (std::int32_t i = cells.i_first >> shift; i <= (cells.i_last + beyond) >> shift;
                 ++i) {
                at[axes.i] = i;
                at[axes.j] = j;
                at[axes.k] = k;
                const auto& brick = pyramid_.brick(level, at[0], at[1], at[2]);
                const bool may_hold = (static_cast<float>(brick.lo) < bounds_.above) &&
                                      (static_cast<float>(brick.hi) > bounds_.below);
                if (may_hold && !take(i, j)) return;
            }
        }
    }
}

template <class Sample, std::size_t support>
bool LevelGrid<Sample, support>::bricks_may_hold(int level, const CellRectangle& cells,
                                                 const LayerRange& layers,
                                                 const WalkAxes& axes) const {
    constexpr std::int32_t most_bricks = 16;
    const int shift = lowest_shift + level;
    const std::int32_t cols = (cells.i_last >> shift) - (cells.i_first >> shift) + 1;
    const std::int32_t rows = (cells.j_last >> shift) - (cells.j_first >> shift) + 1;
    if (cols > most_bricks || rows > most_bricks || cols * rows > most_bricks) return true;
    bool any = false;
    visit_bricks(level, cells, layers, axes, [&any](std::int32_t, std::int32_t) {
        any = true;
        return false;
    });
    return any;
}

template <class Sample, std::size_t support>
CellRectangle LevelGrid<Sample, support>::in_bricks(const CellRectangle& cells,
                                                    const LayerRange& layers,
                                                    const WalkAxes& axes) const {
    CellRectangle held{.i_first = cells.i_last + 1,
                       .i_last = cells.i_first - 1,
                       .j_first = cells.j_last + 1,
                       .j_last = cells.j_first - 1};
    visit_bricks(0, cells, layers, axes, [&](std::int32_t i, std::int32_t j) {
        const std::int32_t i_low = i << lowest_shift;
        const std::int32_t j_low = j << lowest_shift;
        constexpr std::int32_t width = std::int32_t{1} << lowest_shift;
        held.i_first = std::min(held.i_first, std::max(i_low - beyond, cells.i_first));
        held.i_last = std::max(held.i_last, std::min(i_low + width - 1, cells.i_last));
        held.j_first = std::min(held.j_first, std::max(j_low - beyond, cells.j_first));
        held.j_last = std::max(held.j_last, std::min(j_low + width - 1, cells.j_last));
        return true;
    });
    return held;
}

template <class Sample, std::size_t support>
void LevelGrid<Sample, support>::copy(const Patch& patch, std::ptrdiff_t k_stride,
                                      std::size_t slices, SlabSamples& slab) {
    if (patch.i_stride == 1) {
        for (std::size_t slice = 0; slice < slices; ++slice) {
            Patch of = patch;
            of.first += static_cast<std::ptrdiff_t>(slice) * k_stride;
            for (std::size_t row = 0; row < patch.rows; ++row)
                copy_row(of, row, slab.row_at(slice, row));
        }
        return;
    }
    for (std::size_t row = 0; row < patch.rows; ++row) {
        const Sample* from = patch.first + static_cast<std::ptrdiff_t>(row) * patch.j_stride;
        for (std::size_t i = 0; i < patch.count; ++i, from += patch.i_stride) {
            for (std::size_t slice = 0; slice < slices; ++slice) {
                slab.row_at(slice, row)[i] =
                    static_cast<float>(from[static_cast<std::ptrdiff_t>(slice) * k_stride]);
            }
        }
    }
}

template <class Sample, std::size_t support>
void LevelGrid<Sample, support>::find_bits(const Patch& patch, CellMask::FaceBits& bits) const {
    if constexpr (std::is_same_v<Sample, float>) {
        if (patch.i_stride == 1) {
            return sample_bits(patch.first, patch.j_stride, patch.rows, patch.count, bounds_,
                               bits.data());
        }
    }
    std::array<float, CellMask::most_cells + 1> samples;
    for (std::size_t row = 0; row < patch.rows; ++row) {
        copy_row(patch, row, samples.data());
        sample_bits(samples.data(), 0, 1, patch.count, bounds_, &bits[row]);
    }
}

template <class Sample, std::size_t support>
void LevelGrid<Sample, support>::begin(const CellRectangle& cells, const LayerRange& layers,
                                       const WalkAxes& axes, CellMask& mask) const {
    mask.cells = cells;
    mask.layers = layers;
    mask.known = {};
    if (!mask.is_small()) return;
    const Patch patch = patch_of(cells, layers.low, axes);
    mask.samples.begin(patch.count, patch.rows);
    const auto slices = static_cast<std::size_t>(layers.high - layers.low) + support;
    if (!is_row(patch)) return copy(patch, strides_[axes.k], slices, mask.samples);
    // Prefetch all rows, so that they are on their way while the first slices are looked at.
    for (std::size_t slice = 0; slice < slices; ++slice) {
        for (std::size_t row = 0; row < patch.rows; ++row) {
            hwy::Prefetch(patch.first + static_cast<std::ptrdiff_t>(slice) * strides_[axes.k] +
                          static_cast<std::ptrdiff_t>(row) * patch.j_stride);
        }
    }
}

/// Finds the bits of a slice's faces, where rays may be in the layers whose cells lie on its
/// samples.
template <class Sample, std::size_t support>
void LevelGrid<Sample, support>::find_face(std::size_t slice, const RayReach& reach,
                                           const WalkAxes& axes, CellMask& mask) const {
    const std::int32_t layer = mask.layers.low + static_cast<std::int32_t>(slice);
    const Patch patch = patch_of(mask.cells, layer, axes);
    CellMask::FaceBits& face = mask.faces[slice];
    const SlabRows cells = mask.rows_of(reach.cells(std::max(layer - beyond - 1, mask.layers.low),
                                                    std::min(layer, mask.layers.high)));
    if (mask.is_small()) {
        take(patch, slice, {.first = cells.first, .last = cells.last + support - 1}, mask.samples,
             face);
    } else {
        find_bits(patch, face);
    }
    // Combine the bits of the samples of each face, along both axes.
    for (std::size_t row = cells.first; row <= cells.last; ++row) {
        SampleBits all = face[row];
        for (std::size_t n = 1; n < support; ++n) {
            all.above &= face[row + n].above;
            all.below &= face[row + n].below;
        }
        face[row] = all;
        for (std::size_t n = 1; n < support; ++n) {
            face[row].above &= all.above >> n;
            face[row].below &= all.below >> n;
        }
    }
    mask.known[slice] = true;
}

template <class Sample, std::size_t support>
void LevelGrid<Sample, support>::mark(std::int32_t layer, const RayReach& reach,
                                      const WalkAxes& axes, CellMask& mask) const {
    const auto lower = static_cast<std::size_t>(layer - mask.layers.low);
    // Find the faces' bits of slices that are not known yet.
    for (std::size_t slice = lower; slice < lower + support; ++slice) {
        if (!mask.known[slice]) find_face(slice, reach, axes, mask);
    }
    const CellRectangle& cells = mask.cells;
    const std::uint64_t valid = (std::uint64_t{2} << (cells.i_last - cells.i_first)) - 1;
    mask.rows = mask.rows_of(reach.cells(layer, layer));
    mask.bits = {};
    std::uint64_t any = 0;
    // Mark the cells whose samples are not all on one side of the level.
    for (std::size_t row = mask.rows.first; row <= mask.rows.last; ++row) {
        SampleBits all = mask.faces[lower][row];
        for (std::size_t n = 1; n < support; ++n) {
            all.above &= mask.faces[lower + n][row].above;
            all.below &= mask.faces[lower + n][row].below;
        }
        mask.bits[row] = ~(all.above | all.below) & valid;
        any |= mask.bits[row];
    }
    mask.layer = layer;
    mask.any = any != 0;
    // Bound the error of f: by places in floats (block_lanes.cpp), the rounded level, underflows.
    constexpr float of_places = support == 2 ? 0x1p-11F : 0x1p-10F;
    mask.error = of_places * mask.samples.largest +
                 static_cast<float>(0x1p-22 * std::abs(level_) + error_) + 0x1p-120F;
}

}  // namespace zeroset
