#pragma once

#include "engine/trace/voxels/block_lanes.hpp"
#include "engine/trace/voxels/ray_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// The layers of a slab, the least and the greatest one.
struct LayerRange {
    std::int32_t low, high;
};

/// The cells that some rays of a bundle are in, in the layers of a slab.
class RayReach {
public:
    /// The cells of the rays `open` in these layers.
    RayReach(const RayColumns& columns, const LayerRange& layers, std::uint64_t open)
        : low_(extent_of(columns, layers.low, open)),
          high_(extent_of(columns, layers.high + 1.0, open)),
          layers_(layers) {}

    /// The cells in some of these layers. Each ray is a line: between two planes the least place is
    /// not below the line from the one's least to the other's, nor the largest above theirs.
    [[nodiscard]] CellRectangle cells(std::int32_t low, std::int32_t high) const {
        const RayExtent from = at(low);
        const RayExtent to = at(high + 1);
        const auto first = [](double a, double b) {
            return static_cast<std::int32_t>(std::floor(std::min(a, b) - spare));
        };
        const auto last = [](double a, double b) {
            return static_cast<std::int32_t>(std::floor(std::max(a, b) + spare));
        };
        return {.i_first = first(from.i_low, to.i_low),
                .i_last = last(from.i_high, to.i_high),
                .j_first = first(from.j_low, to.j_low),
                .j_last = last(from.j_high, to.j_high)};
    }

private:
    static constexpr double spare = 1e-3;  ///< more than rounding in float moves places by

    [[nodiscard]] RayExtent at(std::int32_t k) const {
        const double share =
            static_cast<double>(k - layers_.low) / (layers_.high + 1 - layers_.low);
        const auto between = [&](double a, double b) { return a + share * (b - a); };
        return {.i_low = between(low_.i_low, high_.i_low),
                .i_high = between(low_.i_high, high_.i_high),
                .j_low = between(low_.j_low, high_.j_low),
                .j_high = between(low_.j_high, high_.j_high)};
    }

    RayExtent low_, high_;
    LayerRange layers_;
};

/// A slab of a grid, and which cells of one of its layers may hold the level: a bit each.
struct CellMask {
    static constexpr int most_cells = 63;  ///< along each axis across
    static constexpr int most_layers = 4;
    static constexpr int most_beyond = 3;  ///< samples beyond a cell's first one

    static bool fits(const CellRectangle& cells) {
        constexpr int most = most_cells - most_beyond;
        return cells.i_last - cells.i_first < most && cells.j_last - cells.j_first < most;
    }

    CellRectangle cells{};
    LayerRange layers{};
    std::int32_t layer = 0;  ///< that is marked
    bool any = false;
    SlabRows rows{};  ///< of the marked layer's cells that rays are in
    std::array<std::uint64_t, most_cells> bits{};
    SlabSamples samples{};  ///< where `is_small`
    float error = 0;        ///< as AskedLayer has it

    /// A slice's cell faces across the axis: whether all samples of each are above, or below.
    using FaceBits = std::array<SampleBits, most_cells + 1>;
    std::array<FaceBits, most_layers + most_beyond> faces{};
    std::array<bool, most_layers + most_beyond> known{};

    /// The rows of the mask's cells that are among the cells `of`, or one row.
    [[nodiscard]] SlabRows rows_of(const CellRectangle& of) const {
        const auto row = [&](std::int32_t j) {
            return static_cast<std::size_t>(std::clamp(j, cells.j_first, cells.j_last) -
                                            cells.j_first);
        };
        return {.first = row(of.j_first), .last = row(of.j_last)};
    }
    /// Whether a cell may hold the level; those beyond the rectangle do not, or no ray is in them.
    [[nodiscard]] bool may_hold(std::int32_t i, std::int32_t j) const {
        if (i < cells.i_first || i > cells.i_last || j < cells.j_first || j > cells.j_last)
            return false;
        const auto row = static_cast<std::size_t>(j - cells.j_first);
        return (bits[row] >> (i - cells.i_first) & 1U) != 0;
    }
    /// Whether rays can be asked all at once (rays_at_level).
    [[nodiscard]] bool is_small() const {
        constexpr std::int32_t most = 32;  // bits of NearCells
        static_assert(most + most_beyond == SlabSamples::most);
        return cells.i_last - cells.i_first < most && cells.j_last - cells.j_first < most;
    }
    /// The marked cells and those before them, for rays of at most this slope.
    [[nodiscard]] NearCells near(double slope) const {
        NearCells near;
        const auto count = static_cast<std::size_t>(cells.j_last - cells.j_first + 1);
        const bool far = slope > 0.99;  // with what rounding moves places by
        for (std::size_t row = 0; row < count; ++row) {
            std::uint64_t marks = bits[row];
            if (row + 1 < count) marks |= bits[row + 1];
            if (far && row + 2 < count) marks |= bits[row + 2];
            const std::uint64_t beside = far ? marks >> 1U | marks >> 2U : marks >> 1U;
            near.rows[row] = static_cast<std::uint32_t>(marks | beside);
        }
        return near;
    }
    /// Whether cells between these places may hold the level.
    [[nodiscard]] bool may_hold_between(double i_low, double i_high, double j_low,
                                        double j_high) const {
        // Truncated to cells: from the rectangle's first one on, places are above 0.
        const std::int32_t first = std::max(static_cast<std::int32_t>(i_low - cells.i_first), 0);
        const std::int32_t last = std::min(static_cast<std::int32_t>(i_high - cells.i_first),
                                           cells.i_last - cells.i_first);
        const std::int32_t first_row =
            std::max(static_cast<std::int32_t>(j_low - cells.j_first), 0);
        const std::int32_t last_row = std::min(static_cast<std::int32_t>(j_high - cells.j_first),
                                               cells.j_last - cells.j_first);
        if (first > last) return false;
        const std::uint64_t wanted = (std::uint64_t{2} << last) - (std::uint64_t{1} << first);
        for (std::int32_t row = first_row; row <= last_row; ++row) {
            if ((bits[static_cast<std::size_t>(row)] & wanted) != 0) return true;
        }
        return false;
    }
};

}  // namespace zeroset
