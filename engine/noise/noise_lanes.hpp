#pragma once

#include <cstddef>

// The means of lattice_noise.hpp for many points and parts of cells at once, in the machine's
// widest vectors. Arrays hold a number for each; those beyond `count` mean nothing, if they are
// computed at all. What is added, and in which order, is the same on every machine, without fused
// operations. In any rounding mode.

namespace zeroset {

/// The linear functions of cells' corners: their numbers at the cell's first corner, and their
/// gradients, which are absent in value noise. Corner c is at (c & 1, c >> 1 & 1, c >> 2 & 1).
template <std::size_t most>
struct CornerLanes {
    using Numbers = double[most];

    alignas(64) Numbers number[8];
    Numbers gradient[3][8];
};

/// Points, each in a cell.
struct NoisePoints {
    static constexpr std::size_t most = 16;
    using Numbers = double[most];

    CornerLanes<most> corners;
    alignas(64) Numbers share[3];
    Numbers value, slope[3];
    std::size_t count;
};
/// Makes values and slopes.
void mix_noise(NoisePoints& points, bool has_gradients);

/// Parts of boxes, each in one cell.
struct NoiseParts {
    static constexpr std::size_t most = 32;
    using Numbers = double[most];

    CornerLanes<most> corners;
    alignas(64) Numbers from[3];
    Numbers to[3];
    Numbers lo, hi;
    Numbers slope_lo[3], slope_hi[3];
    std::size_t count;
};
/// Encloses values and slopes over the parts, but for roundings.
void enclose_noise(NoiseParts& parts, bool has_gradients);

}  // namespace zeroset
