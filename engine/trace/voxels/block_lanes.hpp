#pragma once

#include "engine/trace/voxels/ray_block.hpp"
#include "engine/trace/voxels/slab_lanes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace zeroset {

inline constexpr std::size_t block_rays = 64;  ///< of a bundle: bits of a word
inline constexpr int block_size = 8;           ///< pixels along a side of a bundle

/// Where the rays of a bundle are across its axis, in places of the grid: at + slope * k where the
/// axis is at k.
struct RayColumns {
    alignas(64) std::array<double, block_rays> i_at{}, i_slope{}, j_at{}, j_slope{};
};

/// The rays of a bundle along `axes` that begins at the pixel of (u, v), `pixel` apart; returns
/// the largest slope.
double make_columns(const IndexRays& rays, const WalkAxes& axes, double u, double v, double pixel,
                    RayColumns& columns);

/// How far some rays of a bundle reach across where the axis is at k.
struct RayExtent {
    double i_low, i_high, j_low, j_high;
};
/// The extent of the rays `open`, one or more, where the axis is at k.
RayExtent extent_of(const RayColumns& columns, double k, std::uint64_t open);

/// RayColumns from a slab's first cells on, in cells: at + slope * (layer - the slab's lowest).
struct SlabRays {
    alignas(64) std::array<float, block_rays> i_at{}, i_slope{}, j_at{}, j_slope{};
};
void count_from(const RayColumns& columns, double i, double j, double layer, SlabRays& rays);

/// The marked cells of a layer, a bit each: 32 along i, rows along j. A cell is also marked for
/// those before it along either axis: as far as a ray goes in a layer.
struct NearCells {
    alignas(64) std::array<std::uint32_t, 64> rows{};
};

/// A layer of a slab as rays are asked about it.
struct AskedLayer {
    const SlabSamples& samples;
    const NearCells& marked;
    std::size_t layer;  ///< from the slab's lowest one
    SlabRows rows;      ///< of cells whose samples the slab has
    bool is_spline;     ///< else trilinear
    float error;        ///< more than what floats and places in them make of f
};

/// The rays among `open` on which f may come nearer to 0 than `error` in a layer, and some others,
/// a bit each: of those that are near marked cells, the ones whose cubic has not all its Bernstein
/// coefficients on one side in some cell. No ray is steeper than 1.5 across.
std::uint64_t rays_at_level(const SlabRays& rays, const AskedLayer& asked, std::uint64_t open);

}  // namespace zeroset
