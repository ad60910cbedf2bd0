#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

/// The samples about a slab's cells less the level, in floats: `rows` rows of `row` each, slice by
/// slice, padded.
struct SlabSamples {
    static constexpr std::size_t most = 35;     ///< samples along an axis across
    static constexpr std::size_t longest = 48;  ///< a row, padded
    static constexpr std::size_t most_slices = 7;

    static constexpr std::size_t behind = 4;  ///< the last ones are loaded four at a time

    alignas(64) std::array<float, longest * most * most_slices + behind> numbers{};
    std::size_t row = 0, rows = 0;
    std::size_t count = 0;  ///< samples of a row that count
    float largest = 0;      ///< of |number|, at least

    /// Takes slices of this size; `row_count`: of rows.
    void begin(std::size_t row_length, std::size_t row_count) {
        constexpr std::size_t widest = 16;  ///< lanes
        row = (row_length + widest - 1) / widest * widest;
        rows = row_count;
        count = row_length;
        largest = 0;
    }
    [[nodiscard]] float* row_at(std::size_t slice, std::size_t at) {
        return &numbers[(slice * rows + at) * row];
    }
};

/// A level, rounded, with numbers that are surely above and below it.
struct LevelBounds {
    float level, above, below;
};

/// The samples that are no less than `above`, and those that are no larger than `below`, a bit
/// each.
struct SampleBits {
    std::uint64_t above, below;
};
/// Finds the bits of rows of at most 64 samples, `stride` apart.
void sample_bits(const float* samples, std::ptrdiff_t stride, std::size_t rows, std::size_t count,
                 const LevelBounds& level, SampleBits* bits);
/// Some rows of a slab.
struct SlabRows {
    std::size_t first, last;
};
/// Finds the bits of rows of a slice and puts its samples, less the level, into the slab; `samples`
/// is where the slice's first row would be.
void take_slice(const float* samples, std::ptrdiff_t stride, const LevelBounds& level,
                std::size_t slice, const SlabRows& rows, SlabSamples& slab, SampleBits* bits);

}  // namespace zeroset
