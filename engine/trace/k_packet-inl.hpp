// A packet of rays for K-bisection. Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_PACKET_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_PACKET_INL
#undef ZEROSET_K_PACKET_INL
#else
#define ZEROSET_K_PACKET_INL
#endif

#include "engine/trace/tracer.hpp"

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using DUint = hn::RebindToUnsigned<D>;
using D64 = hn::Repartition<double, D>;
using DHalf = hn::Half<D>;
using V = hn::Vec<D>;
using V64 = hn::Vec<D64>;
using VHalf = hn::Vec<DHalf>;
using M = hn::Mask<D>;
constexpr D d;
constexpr DUint du;
constexpr D64 d64;
constexpr DHalf d_half;
constexpr std::size_t lanes = hn::MaxLanes(d);
constexpr std::size_t vector_bytes = lanes * sizeof(float);
constexpr int block_cols = lanes == 4 ? 2 : 4;
constexpr int block_rows = static_cast<int>(lanes) / block_cols;
constexpr unsigned all_lanes = (1U << lanes) - 1U;

constexpr int max_top_depth = 5;  ///< the top slices are at most 2^-5 of the clip box wide
constexpr int group_size = 16;    ///< packets a batch, each with two boxes a ray
constexpr std::size_t batch_capacity = 2 * group_size * lanes;

/// The mask of the rays whose bits are set.
HWY_INLINE M mask_of(unsigned bits) {
    alignas(vector_bytes) std::uint32_t mask[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane)
        mask[lane] = 0U - (bits >> lane & 1U);
    return hn::MaskFromVec(hn::BitCast(d, hn::Load(du, mask)));
}

/// The axes of a packet, K first: world axes, negated where `mirrored`, so that no coordinate falls
/// along the packet's rays; and what follows from them for a frame.
struct Axes {
    int world[3];
    bool mirrored[3];
    /// Where a batch (-lo of x, y, z, then hi of x, y, z) holds -from and to, in floats.
    std::size_t from_offset[3], to_offset[3];
    double eye[3];
    double to_lo[3], to_hi[3];  ///< from the eye to the clip box
    double error[3];            ///< above the rounding errors of a few operations in double
    double k_size;              ///< the largest |K| in the clip box
    float origin;               ///< where the grid of slices starts; not behind the clip box
    float unit;                 ///< width of the slices at d_stop
    std::int32_t slice_cells;   ///< of d_stop to a top slice: a power of two, at least 2
    int slice_count;            ///< top slices that cover the clip box, at most 64
    alignas(64) double lane_offset[3][lanes];  ///< directions relative to the block's first pixel
};

/// A coordinate as a function of K on each ray: between -(neg_lo - slope k) and hi + slope k.
struct Line {
    alignas(vector_bytes) float slope[lanes];  ///< not negative, on the packet's rays
    alignas(vector_bytes) float neg_lo[lanes];
    alignas(vector_bytes) float hi[lanes];
};

/// Rays that march together along K. They look at slices of a row of binary trees over K, the top
/// slices: the current one is [cell, cell + size] in units of the finest slice, and is looked at by
/// halves.
struct Packet {
    alignas(vector_bytes) float k_in[lanes];      ///< where the ray enters the clip box
    alignas(vector_bytes) float k_out[lanes];     ///< where it leaves
    alignas(vector_bytes) float alive[lanes];     ///< mask: rays that still look for their root
    alignas(vector_bytes) float hit_from[lanes];  ///< the slice where the search stopped
    alignas(vector_bytes) float hit_to[lanes];
    alignas(vector_bytes) float stretch[lanes];  ///< distance along the ray for 1 along K
    Line line[2];                                ///< of U and V
    const Axes* axes;
    unsigned hit;        ///< bits of the rays that stopped at a root
    unsigned unsettled;  ///< bits of the rays that have a gap_from
    int col, row;        ///< of the block's first pixel in the tile
    float origin, unit;
    std::int32_t slice_cells;
    std::int32_t cell, size;  ///< size is a power of two, at least 2
    std::uint32_t pending;    ///< sizes of the right halves, on the way up, still to be looked at
    std::uint64_t slices;     ///< bits of the top slices still to be looked at
    // Last, and aligned so that each packet begins a cache line.
    alignas(64) float gap_from[lanes];  ///< the first slice where f is not continuous

    /// The floats that divide K: increasing, and equal for equal indices.
    [[nodiscard]] float grid(std::int32_t index) const {
        return origin + static_cast<float>(index) * unit;
    }

    /// To the nearest slice still to be looked at; false when there is none.
    bool pop() {
        if (pending != 0) {
            const std::uint32_t lowest = pending & (0U - pending);
            pending ^= lowest;
            size = static_cast<std::int32_t>(lowest);
            cell = (cell & ~(2 * size - 1)) + size;
            return true;
        }
        if (slices == 0) return false;
        size = slice_cells;
        cell = std::countr_zero(slices) * slice_cells;
        slices &= slices - 1;
        return true;
    }
    /// Into the halves that may hold a root, the left one first; false when the packet is done.
    bool go_on(bool left, bool right) {
        if (!left && !right) return pop();
        const std::int32_t half = size / 2;
        cell += left ? 0 : half;
        pending |= left && right ? static_cast<std::uint32_t>(half) : 0U;
        size = half;
        return true;
    }
    /// Rays of `found` end at [from, to].
    HWY_INLINE void stop_at(M found, V from, V to) {
        hit |= bits_of(found);
        hn::Store(hn::IfThenElse(found, from, hn::Load(d, hit_from)), d, hit_from);
        hn::Store(hn::IfThenElse(found, to, hn::Load(d, hit_to)), d, hit_to);
        const M others = hn::AndNot(found, hn::MaskFromVec(hn::Load(d, alive)));
        hn::Store(hn::VecFromMask(d, others), d, alive);
    }
    /// Rays of `found` go on behind a slice from `from` where f is not continuous.
    HWY_INLINE void pass_gap(M found, V from) {
        if (hn::AllFalse(d, found)) return;
        const unsigned first = bits_of(found) & ~unsettled;
        if (first == 0) return;
        unsettled |= first;
        hn::Store(hn::IfThenElse(mask_of(first), from, hn::Load(d, gap_from)), d, gap_from);
    }
    [[nodiscard]] TileHits::Pixel pixel(int lane) const {
        return {static_cast<std::int16_t>(col + lane % block_cols),
                static_cast<std::int16_t>(row + lane / block_cols)};
    }
    static unsigned bits_of(M mask) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, mask, bytes);
        return bytes[0] | static_cast<unsigned>(bytes[1]) << 8U;
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
