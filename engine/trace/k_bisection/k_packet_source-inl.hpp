// The rays of a tile as packets for K-bisection.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_PACKET_SOURCE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_PACKET_SOURCE_INL
#undef ZEROSET_K_PACKET_SOURCE_INL
#else
#define ZEROSET_K_PACKET_SOURCE_INL
#endif

#include "engine/scene/tolerance.hpp"
#include "engine/trace/k_bisection/k_axes-inl.hpp"
#include "engine/trace/k_bisection/k_rays-inl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Makes the packets of a tile, block of pixels by block of pixels. Must outlive them.
template <class Real>
class PacketSource {
public:
    PacketSource(const TraceFrame& frame, const Tile& tile);
    /// Sets up the next packet, with the top slices that its rays meet; false when there is none
    /// left.
    bool next(Packet<Real>& packet);
    /// The axes for a ray; they live as long as the source.
    const Axes<Real>& axes_for(const glm::dvec3& direction) { return axes_.of(direction); }
    [[nodiscard]] const PacketRays& rays() const { return rays_; }

private:
    bool next_block();
    /// Makes the rays of `bits` alive that meet the clip box.
    static void set_up_lanes(Packet<Real>& packet, unsigned bits);
    /// Keeps alive those of the living rays that have anything between `in` and `out`.
    static void bound_lanes(Packet<Real>& packet, M<Real> alive, V<Real> in, V<Real> out);
    /// Ends the rays at the tile's limits.
    void limit_lanes(Packet<Real>& packet) const;
    /// Chooses the packet's slices; false when no ray is alive.
    bool set_up_slices(Packet<Real>& packet) const;
    [[nodiscard]] int epsilon_depth(const Packet<Real>& packet, Real k_min, Real k_max) const;

    const TraceFrame& frame_;
    Tile tile_;
    PacketRays rays_;
    AxesTable<Real> axes_;
    int col_ = -block_cols<Real>, row_ = 0;
    unsigned pending_ = 0;  ///< rays of the current block not yet in a packet
};

template <class Real>
PacketSource<Real>::PacketSource(const TraceFrame& frame, const Tile& tile)
    : frame_(frame), tile_(tile), rays_(frame, tile), axes_(frame, rays_) {}

template <class Real>
bool PacketSource<Real>::next_block() {
    constexpr int cols = block_cols<Real>;
    constexpr int rows = block_rows<Real>;
    col_ += cols;
    if (col_ >= tile_.cols) {
        col_ = 0;
        row_ += rows;
    }
    if (row_ >= tile_.rows) return false;
    pending_ = all_lanes<Tag<Real>>;
    if (col_ + cols > tile_.cols || row_ + rows > tile_.rows) {
        for (int lane = 0; lane < static_cast<int>(lanes<Real>); ++lane) {
            const bool inside = col_ + lane % cols < tile_.cols && row_ + lane / cols < tile_.rows;
            if (!inside) pending_ &= ~(1U << lane);
        }
    }
    return true;
}

template <class Real>
bool PacketSource<Real>::next(Packet<Real>& packet) {
    constexpr bool two_parts = lanes<Real> > part_lanes;
    for (;;) {
        if (pending_ == 0 && !next_block()) return false;
        // Enclose the block's rays in the axes of the first pending one.
        const int first = std::countr_zero(pending_);
        const Axes<Real>& axes = axes_for(
            rays_.direction.at(col_ + first % block_cols<Real>, row_ + first / block_cols<Real>));
        const glm::dvec3 start = rays_.start.at(col_, row_);
        const glm::dvec3 direction = rays_.direction.at(col_, row_);
        const PartRays low = part_of(axes, start, direction, 0);
        const PartRays high = two_parts ? part_of(axes, start, direction, part_lanes) : low;
        const unsigned fitting = low.fitting() | high.fitting() << part_lanes;
        // Take the rays that fit the axes; the first one always does, others make packets of their
        // own.
        const unsigned mine = pending_ & (fitting | 1U << first);
        pending_ &= ~mine;
        if (low.all_miss() && high.all_miss()) continue;
        // Set up the packet.
        packet.axes = &axes;
        packet.col = col_;
        packet.row = row_;
        store_part(low, 0, packet);
        if constexpr (two_parts) store_part(high, part_lanes, packet);
        set_up_lanes(packet, mine);
        if (tile_.limits != nullptr) limit_lanes(packet);
        if (set_up_slices(packet)) return true;
    }
}

template <class Real>
HWY_INLINE void PacketSource<Real>::bound_lanes(Packet<Real>& packet, M<Real> alive, V<Real> in,
                                                V<Real> out) {
    alive = hn::And(alive, hn::Le(in, out));
    // The other rays stand still at one place, so that they have finite boxes.
    const V<Real> anywhere = hn::Set(d<Real>, packet.axes->origin);
    hn::Store(hn::VecFromMask(d<Real>, alive), d<Real>, packet.alive);
    hn::Store(hn::IfThenElse(alive, in, anywhere), d<Real>, packet.k_in);
    hn::Store(hn::IfThenElse(alive, out, anywhere), d<Real>, packet.k_out);
}

template <class Real>
HWY_INLINE void PacketSource<Real>::set_up_lanes(Packet<Real>& packet, unsigned bits) {
    bound_lanes(packet, mask_of(d<Real>, bits), hn::Load(d<Real>, packet.k_in),
                hn::Load(d<Real>, packet.k_out));
    hn::Store(hn::Zero(d<Real>), d<Real>, packet.hit_from);
    hn::Store(hn::Zero(d<Real>), d<Real>, packet.hit_to);
    packet.hit = 0;
    packet.unsettled = 0;
}

/// Leaves of each ray as many slices behind its limit as its certificate may look at, so that what
/// is found before the limit does not depend on it. With other rules than d_stop slices follow from
/// the rays' ends; those stay.
template <class Real>
HWY_NOINLINE void PacketSource<Real>::limit_lanes(Packet<Real>& packet) const {
    if (frame_.stop.rule != StopRule::DStop) return;
    const Axes<Real>& axes = *packet.axes;
    alignas(vector_bytes<Real>) Real limit[lanes<Real>];
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane) {
        limit[lane] = static_cast<Real>(tile_.limits[packet.pixel(static_cast<int>(lane)).index()]);
    }
    // Where the limit is along K: rounded upward, but for the stretch.
    const V<Real> grow = number<Real>(1.0 + 0x1p-20);
    const V<Real> stretch = hn::Load(d<Real>, packet.stretch);
    const V<Real> distance =
        hn::Add(hn::Load(d<Real>, limit), hn::Set(d<Real>, above<Real>(-axes.start_depth)));
    const V<Real> along = hn::Mul(hn::Div(distance, stretch), grow);
    const V<Real> end = hn::Add(along, hn::Load(d<Real>, packet.k_start));
    // How wide slices may be there.
    const V<Real> unit = hn::Set(d<Real>, axes.unit);
    const V<Real> widest = hn::Set(d<Real>, axes.unit * static_cast<Real>(axes.coarsest / 2));
    const V<Real> there =
        hn::Mul(along, hn::Set(d<Real>, static_cast<Real>(std::ldexp(1.0, -axes.near_shift))));
    const V<Real> slice = hn::Max(unit, hn::Min(there, widest));
    const V<Real> spare = hn::Mul(number<Real>(1 + extra_slices), slice);
    bound_lanes(packet, hn::MaskFromVec(hn::Load(d<Real>, packet.alive)),
                hn::Load(d<Real>, packet.k_in),
                hn::Min(hn::Load(d<Real>, packet.k_out), hn::Add(end, spare)));
}

/// The halvings of a top slice under the epsilon rule.
template <class Real>
int PacketSource<Real>::epsilon_depth(const Packet<Real>& packet, Real k_min, Real k_max) const {
    Real longest = std::numeric_limits<Real>::min();  // the packet's Delta [Knoll07, eq. 7]
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane) {
        const Real extent = packet.k_out[lane] - packet.k_in[lane];
        const Real u = packet.line[0].slope_hi[lane];
        const Real v = packet.line[1].slope_hi[lane];
        longest = std::max(longest, extent * (1 + u * u + v * v));
    }
    const auto packet_share = static_cast<double>((k_max - k_min) / longest);
    const double width = packet_share * frame_.stop.value;  // eq. 6
    const Axes<Real>& axes = *packet.axes;
    const auto slice = static_cast<double>(axes.unit * static_cast<Real>(axes.slice_cells));
    const int finest = std::countr_zero(static_cast<std::uint64_t>(axes.slice_cells));
    return std::clamp(static_cast<int>(std::ceil(std::log2(slice / width))), 1, finest);
}

template <class Real>
bool PacketSource<Real>::set_up_slices(Packet<Real>& packet) const {
    const M<Real> alive = hn::MaskFromVec(hn::Load(d<Real>, packet.alive));
    if (hn::AllFalse(d<Real>, alive)) return false;
    // Find the least and the greatest K of the living rays.
    const V<Real> far = hn::Set(d<Real>, std::numeric_limits<Real>::infinity());
    const V<Real> in = hn::IfThenElse(alive, hn::Load(d<Real>, packet.k_in), far);
    const V<Real> out = hn::IfThenElse(alive, hn::Load(d<Real>, packet.k_out), hn::Neg(far));
    const Real k_min = hn::GetLane(hn::MinOfLanes(d<Real>, in));
    const Real k_max = hn::GetLane(hn::MaxOfLanes(d<Real>, out));
    // Lay out the grid.
    const Axes<Real>& axes = *packet.axes;
    packet.origin = axes.origin;
    packet.unit = axes.unit;
    packet.slice_cells = axes.slice_cells;
    const Real slice = axes.unit * static_cast<Real>(axes.slice_cells);
    if (frame_.stop.rule == StopRule::Epsilon) {
        packet.slice_cells = std::int64_t{1} << epsilon_depth(packet, k_min, k_max);
        packet.unit = slice / static_cast<Real>(packet.slice_cells);
    }
    packet.look = packet.unit;
    // Mark the top slices from the first to the last that they meet.
    int first = static_cast<int>((k_min - axes.origin) / slice);
    int last = std::min(axes.slice_count - 1, static_cast<int>((k_max - axes.origin) / slice));
    while (first > 0 && packet.grid(first * packet.slice_cells) > k_min)
        --first;
    while (last < axes.slice_count - 1 && packet.grid((last + 1) * packet.slice_cells) < k_max) {
        ++last;
    }
    const std::uint64_t up_to_last = last >= 63 ? ~0ULL : (2ULL << last) - 1;
    packet.slices = up_to_last & (~0ULL << first);
    packet.pending = 0;
    return true;
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
