#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

inline constexpr std::size_t block_rays = 64;  ///< of a bundle: bits of a word

/// Where the rays of a bundle are across its axis: at + slope * (layer - the bundle's first one),
/// from a cell that all share.
struct RayColumns {
    alignas(64) std::array<float, block_rays> i_at{}, i_slope{}, j_at{}, j_slope{};
};

/// The marked cells of a layer, a bit each: 32 along i, rows along j. A cell is also marked for
/// those up to two before it along either axis.
struct NearCells {
    alignas(64) std::array<std::uint32_t, 64> rows{};
    float layer = 0, i_first = 0, j_first = 0;  ///< as RayColumns counts them
};

/// The rays that may be in marked cells of the layer, and some others, a bit each: those whose
/// least cell along both axes has a mark. No ray is steeper than 1.5 across.
std::uint64_t rays_near(const RayColumns& rays, const NearCells& cells);

/// The samples that are no less than a number, and those that are no larger than another, a bit
/// each.
struct SampleBits {
    std::uint64_t above, below;
};
/// Of each row of samples, at most 64 in each, `stride` apart.
void sample_bits(const float* samples, std::ptrdiff_t stride, std::size_t rows, std::size_t count,
                 float above, float below, SampleBits* bits);

}  // namespace zeroset
