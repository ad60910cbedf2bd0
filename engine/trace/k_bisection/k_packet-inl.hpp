// A packet of rays for K-bisection, in float or double.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_PACKET_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_PACKET_INL
#undef ZEROSET_K_PACKET_INL
#else
#define ZEROSET_K_PACKET_INL
#endif

#include "engine/kernel/kernel.hpp"
#include "engine/real/lanes-inl.hpp"
#include "engine/trace/tile_costs.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real>
constexpr int block_cols = lanes<Real> <= 4 ? 2 : 4;
template <class Real>
constexpr int block_rows = static_cast<int>(lanes<Real>) / block_cols<Real>;

constexpr int max_top_depth = 5;  ///< the top slices are at most 2^-5 of the clip box wide
constexpr int group_size = 16;    ///< packets a batch, each with two boxes a ray
template <class Real>
constexpr std::size_t batch_capacity = 2 * group_size * lanes<Real>;

/// The axes of a packet, K first: world axes, negated where `mirrored`, so that no coordinate falls
/// along the packet's rays; and what follows from them for a frame.
template <class Real>
struct Axes {
    int world[3];
    bool mirrored[3];
    /// Where a batch (-lo of x, y, z, then hi of x, y, z) holds -from and to, in numbers.
    std::size_t from_offset[3], to_offset[3];
    const Region* region;  ///< of the clip box, in world coordinates
    double place_error;    ///< see place_error
    bool parallel;         ///< rays: they have one direction and start at different places
    double start_depth;    ///< of the starts, from the eye or the plane through it
    /// Between the start of the tile's first ray and the clip box, rounded upward.
    double from_lo[3], to_hi[3];
    double box_lo[3], box_hi[3];  ///< of the clip box
    Real neg_lo[3], hi[3];        ///< the clip box, rounded upward
    double k_size;                ///< the largest |K| in the clip box
    double k_reach;  ///< not below any distance in K from a ray's start to a place in the clip box
    double direction_error;    ///< bound for the error of a direction's component
    Real origin;               ///< where the grid of slices starts; not behind the clip box
    Real unit;                 ///< width of the finest slices
    std::int64_t slice_cells;  ///< of them to a top slice: a power of two, at least 2
    int slice_count;           ///< top slices that cover the clip box, at most 64
    /// Slices of up to `coarsest` cells are not halved where they are no wider than the double of
    /// their distance in cells from eye_cell times 2^-near_shift.
    std::int64_t coarsest, eye_cell;
    int near_shift;
    bool certifies;  ///< the finest slices are near enough to the wanted tolerance to be certified
    /// Directions relative to the first pixel's; of parallel rays, starts.
    alignas(64) double lane_offset[3][lanes<Real>];

    /// Times the inverse of a ray's direction along K, a bound for the error of its slope over K,
    /// of at most 4. The two components, twice as good as their bound, take 2.5; the rest is more
    /// than rounding takes.
    [[nodiscard]] double slope_error_share() const { return 4.0 * direction_error; }
};

/// A coordinate as a function of K on each ray: between -(neg_lo - slope_lo k) and hi + slope_hi k.
template <class Real>
struct AxisLines {
    /// Not negative on the packet's rays, but by an error in double; equal in float.
    alignas(vector_bytes<Real>) Real slope_lo[lanes<Real>];
    alignas(vector_bytes<Real>) Real slope_hi[lanes<Real>];
    alignas(vector_bytes<Real>) Real neg_lo[lanes<Real>];
    alignas(vector_bytes<Real>) Real hi[lanes<Real>];
};

/// Rays that march together along K. They look at slices of a row of binary trees over K, the top
/// slices: the current one is [cell, cell + size] in units of the finest slice, and is looked at by
/// halves.
template <class Real>
struct Packet {
    static constexpr std::size_t bytes = vector_bytes<Real>;
    using Numbers = Real[lanes<Real>];

    alignas(bytes) Numbers k_in;      ///< where the ray enters the clip box
    alignas(bytes) Numbers k_out;     ///< where it leaves
    alignas(bytes) Numbers alive;     ///< mask: rays that still look for their root
    alignas(bytes) Numbers hit_from;  ///< the slice where the search stopped
    alignas(bytes) Numbers hit_to;
    alignas(bytes) Numbers k_start;  ///< where the ray starts: at axes->start_depth
    alignas(bytes) Numbers stretch;  ///< distance along the ray for 1 along K
    AxisLines<Real> line[2];         ///< of U and V
    const Axes<Real>* axes;
    unsigned hit;        ///< bits of the rays that stopped at a root
    unsigned unsettled;  ///< bits of the rays that have a gap_from
    int col, row;        ///< of the block's first pixel in the tile
    Real origin, unit;
    Real look;  ///< width of the slices that certificates look at: that of the last hit
    std::int64_t slice_cells;
    std::int64_t cell, size;  ///< size is a power of two, at least 2
    std::uint64_t pending;    ///< sizes of the right halves, on the way up, still to be looked at
    std::uint64_t slices;     ///< bits of the top slices still to be looked at
    // Last, and aligned so that each packet begins a cache line.
    alignas(64) Numbers gap_from;  ///< the first slice where f is not continuous

    /// Tells who asks that so many boxes of each ray were evaluated.
    void tell_costs(TileCosts* costs, double evaluations) const {
        for (int lane = 0; costs != nullptr && lane < static_cast<int>(lanes<Real>); ++lane)
            costs->add(pixel(lane).index(), evaluations);
    }

    /// The numbers that divide K: increasing, and equal for equal indices.
    [[nodiscard]] Real grid(std::int64_t index) const {
        return origin + static_cast<Real>(index) * unit;
    }

    /// Whether the halves of the current slice are not halved any more.
    [[nodiscard]] bool is_finest() const {
        if (size == 2) return true;
        return size <= axes->coarsest && size <= 2 * ((cell - axes->eye_cell) >> axes->near_shift);
    }

    /// To the nearest slice still to be looked at; false when there is none.
    bool pop() {
        if (pending != 0) {
            const std::uint64_t lowest = pending & (0U - pending);
            pending ^= lowest;
            size = static_cast<std::int64_t>(lowest);
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
        const std::int64_t half = size / 2;
        cell += left ? 0 : half;
        pending |= left && right ? static_cast<std::uint64_t>(half) : 0U;
        size = half;
        return true;
    }
    /// Rays of `found` end at [from, to].
    HWY_INLINE void stop_at(M<Real> found, V<Real> from, V<Real> to) {
        hit |= bits_of(d<Real>, found);
        hn::Store(hn::IfThenElse(found, from, hn::Load(d<Real>, hit_from)), d<Real>, hit_from);
        hn::Store(hn::IfThenElse(found, to, hn::Load(d<Real>, hit_to)), d<Real>, hit_to);
        const M<Real> others = hn::AndNot(found, hn::MaskFromVec(hn::Load(d<Real>, alive)));
        hn::Store(hn::VecFromMask(d<Real>, others), d<Real>, alive);
    }
    /// Rays of `found` go on behind a slice from `from` where f is not continuous.
    HWY_INLINE void pass_gap(M<Real> found, V<Real> from) {
        if (hn::AllFalse(d<Real>, found)) return;
        const unsigned first = bits_of(d<Real>, found) & ~unsettled;
        if (first == 0) return;
        unsettled |= first;
        hn::Store(hn::IfThenElse(mask_of(d<Real>, first), from, hn::Load(d<Real>, gap_from)),
                  d<Real>, gap_from);
    }
    [[nodiscard]] TileHits::Pixel pixel(int lane) const {
        return {.col = static_cast<std::int16_t>(col + lane % block_cols<Real>),
                .row = static_cast<std::int16_t>(row + lane / block_cols<Real>)};
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
