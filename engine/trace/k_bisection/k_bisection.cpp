// Earliest zero on a ray by K-bisection [Knoll07, sec. 4 to 5.5 and appendix A].
//   K       the packet's dominant axis, mirrored so that rays go towards +K; U, V the others
//   d_stop  deepest bisection; its cells are 2^-d_stop of the clip box's longest edge
// A packet of rays marches from one K slice to the next; F, the interval extension of f, over the
// box of a slice rejects it, or the slice is halved, down to d_stop.
//
// Differs from the paper:
// - The packet is as wide as the machine's lanes, and a group of packets takes each step together,
//   so that the kernel works on a batch.
// - The top of the bisection, down to 1/32 of the clip box, is looked at for patches of 16x16
// pixels:
//   what is rejected for a patch, with boxes around all its rays, no packet of it looks at.
// - A step looks at both halves of a slice. The boxes are the same, but for those behind a root.
// - Slices are cells of one grid of the clip box, 2^d_stop to its longest edge, whose ends are
//   numbers computed from the index; their U and V come from one multiply-add each instead of the
//   sum of the increments: sound under upward rounding, and without the error of up to d_stop
//   additions. The stack shrinks to a bit for each right half still to be looked at.
// - U and V are mirrored, too, so that neither falls along K; a ray for which one does makes a
//   packet of its own.
// - Slices at a distance may be coarser than those near the eye, see SearchDepth.
// - Boxes are clipped to the part of the ray inside the clip box and the region and in front of the
//   eye. Parallel rays have no eye: they start on a plane before the clip box.
// - A slice on which f is not proved continuous is never a hit (the paper's rule for division,
//   where F is infinite); the ray goes on, and its pixel is no longer certified. Where the
//   first one begins is handed on, as it may lie before another surface's hit.
// - Behind a limit of the tile (nearer surfaces of the scene) a ray ends.
// - A hit whose ends have proved opposite signs is certified, any other is undecided.

#include "engine/trace/k_bisection/k_bisection.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/k_bisection/k_bisection.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/in_precision.hpp"
#include "engine/trace/k_bisection/k_batch-inl.hpp"
#include "engine/trace/k_bisection/k_certificate-inl.hpp"
#include "engine/trace/k_bisection/k_packet-inl.hpp"
#include "engine/trace/k_bisection/k_packet_source-inl.hpp"
#include "engine/trace/k_bisection/k_patch-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The ends of the halves of a packet's current slice, clipped to each ray.
template <class Real>
struct Halves {
    V<Real> from, middle, to;
};

template <class Real>
HWY_INLINE Halves<Real> halves_of(const Packet<Real>& packet) {
    const V<Real> k_in = hn::Load(d<Real>, packet.k_in);
    const V<Real> k_out = hn::Load(d<Real>, packet.k_out);
    const auto clipped = [&](std::int64_t cell) {
        return hn::Min(hn::Max(hn::Set(d<Real>, packet.grid(cell)), k_in), k_out);
    };
    return {clipped(packet.cell), clipped(packet.cell + packet.size / 2),
            clipped(packet.cell + packet.size)};
}

/// Puts the halves of the packet's current slice into the batch.
template <class Real>
HWY_INLINE void store_halves(const Packet<Real>& packet, std::size_t slot, Batch<Real>& batch) {
    const Halves<Real> halves = halves_of(packet);
    store_box(packet, halves.from, halves.middle, 2 * slot, batch);
    store_box(packet, halves.middle, halves.to, 2 * slot + 1, batch);
}

/// The living rays on whose box in the slot F does not exclude 0. A ray that does not meet the
/// slice has the box of its entry or exit there.
template <class Real>
HWY_INLINE M<Real> may_hold_root(const Packet<Real>& packet, const Batch<Real>& batch,
                                 std::size_t slot) {
    const std::size_t at = slot * lanes<Real>;
    const V<Real> zero = hn::Zero(d<Real>);
    const M<Real> rejected = hn::Or(hn::Lt(hn::Load(d<Real>, batch.f_neg_lo + at), zero),
                                    hn::Lt(hn::Load(d<Real>, batch.f_hi + at), zero));
    return hn::AndNot(rejected, hn::MaskFromVec(hn::Load(d<Real>, packet.alive)));
}

template <class Real>
HWY_INLINE M<Real> is_narrow(const Batch<Real>& batch, std::size_t slot, Real delta) {
    const std::size_t at = slot * lanes<Real>;
    const V<Real> width =
        hn::Add(hn::Load(d<Real>, batch.f_neg_lo + at), hn::Load(d<Real>, batch.f_hi + at));
    return hn::Lt(width, hn::Set(d<Real>, delta));
}

/// The rays that may hold a root in each half of a slice.
template <class Real>
struct Candidates {
    M<Real> left, right;
};

/// Ends the rays whose search stops in the packet's current slice: at d_stop all that may hold a
/// root, before only where F is narrower than delta. The others remain candidates.
template <class Real>
Candidates<Real> stop_rays(Packet<Real>& packet, const Candidates<Real>& found, std::size_t slot,
                           const Batch<Real>& batch, Real delta) {
    // Certificates look at slices as wide as the last ones.
    const bool finest = packet.is_finest();
    if (finest) packet.look = packet.unit * static_cast<Real>(packet.size / 2);
    // Find where rays stop: only there do they hit something, and only where f is continuous.
    const M<Real> left_continuous = is_continuous(batch, slot);
    const M<Real> right_continuous = is_continuous(batch, slot + 1);
    const auto stopped = [&](M<Real> candidates, M<Real> continuous, std::size_t at) {
        if (finest) return candidates;
        return hn::And(candidates, hn::And(continuous, is_narrow(batch, at, delta)));
    };
    const M<Real> left_stop = stopped(found.left, left_continuous, slot);
    const M<Real> left_hit = hn::And(left_stop, left_continuous);
    // A ray may stop in the right half only if it has no root to look for in the left one.
    const M<Real> right_stop = hn::AndNot(finest ? left_hit : found.left,
                                          stopped(found.right, right_continuous, slot + 1));
    const M<Real> right_hit = hn::And(right_stop, right_continuous);
    // End the rays at their hits.
    const Halves<Real> halves = halves_of(packet);
    packet.stop_at(left_hit, halves.from, halves.middle);
    packet.stop_at(right_hit, halves.middle, halves.to);
    // Rays that stop where f is not continuous go on, unsettled.
    const M<Real> left_gap = hn::AndNot(left_continuous, left_stop);
    const M<Real> right_gap = hn::AndNot(right_continuous, right_stop);
    packet.pass_gap(hn::Or(left_gap, right_gap),
                    hn::IfThenElse(left_gap, halves.from, halves.middle));
    const M<Real> ended = hn::Or(left_hit, right_hit);
    return {hn::AndNot(ended, found.left), hn::AndNot(ended, found.right)};
}

/// Takes the kernel's answers for the packet's current slice and goes on; false when the packet is
/// finished. `delta`: the width of F at which the search stops before d_stop; 0: never.
template <class Real>
HWY_INLINE bool take_answers(Packet<Real>& packet, std::size_t slot, const Batch<Real>& batch,
                             Real delta) {
    Candidates<Real> found{may_hold_root(packet, batch, 2 * slot),
                           may_hold_root(packet, batch, 2 * slot + 1)};
    const bool finest = packet.is_finest();
    if (finest || delta > 0) {
        if (!hn::AllFalse(d<Real>, hn::Or(found.left, found.right))) {
            found = stop_rays(packet, found, 2 * slot, batch, delta);
            if (hn::AllFalse(d<Real>, hn::MaskFromVec(hn::Load(d<Real>, packet.alive))))
                return false;
        }
        if (finest) return packet.pop();
    }
    return packet.go_on(!hn::AllFalse(d<Real>, found.left), !hn::AllFalse(d<Real>, found.right));
}

/// Hands on the rays of a finished packet that passed a slice where f is not continuous.
template <class Real>
void push_unsettled(const Packet<Real>& packet, TileHits& hits) {
    constexpr float shrink = 1.0F - 0x1p-20F;  // above the rounding errors of `stretch` and a float
    const float first = -float_above(-packet.axes->start_depth);
    for (unsigned bits = packet.unsettled; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        const Real behind = packet.k_start[lane] - packet.gap_from[lane];  // rounded upward
        const float along = static_cast<float>(-(behind * packet.stretch[lane])) * shrink;
        hits.mark_unsettled(packet.pixel(lane), -(-first - std::max(along, 0.0F)));
    }
}

/// The packets of a tile that march, and those that wait for their certificates.
template <class Real>
class Group {
public:
    Group(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters)
        : frame_(frame),
          tile_(tile),
          source_(frame, tile),
          patches_(frame, tile, source_, batch_, counters),
          hits_(hits),
          counters_(counters) {
        for (Packet<Real>& packet : packets_)
            idle_.push_back(&packet);
    }

    void run();

private:
    /// Tops up the marching packets; false when the tile has no more.
    bool refill();
    void retire(Packet<Real>& packet);
    void finish_waiting();

    const TraceFrame& frame_;
    const Tile& tile_;
    Batch<Real> batch_{};            ///< slots 2i, 2i + 1: the slice of marching_[i]
    Batch<Real> certificate_batch_;  ///< of the waiting packets
    PacketSource<Real> source_;
    PatchSlices<Real> patches_;
    TileHits& hits_;
    Counters& counters_;
    std::array<Packet<Real>, 2 * group_size> packets_;
    std::vector<Packet<Real>*> idle_, marching_, waiting_;
};

template <class Real>
bool Group<Real>::refill() {
    while (marching_.size() < group_size) {
        Packet<Real>& packet = *idle_.back();
        if (!source_.next(packet)) return false;
        packet.slices &= patches_.of(packet);
        if (!packet.pop()) continue;
        store_halves(packet, marching_.size(), batch_);
        marching_.push_back(&packet);
        idle_.pop_back();
    }
    return true;
}

/// Takes a packet whose rays have all ended.
template <class Real>
void Group<Real>::retire(Packet<Real>& packet) {
    push_unsettled(packet, hits_);
    if (packet.hit == 0) {
        idle_.push_back(&packet);
        return;
    }
    waiting_.push_back(&packet);
    if (waiting_.size() == group_size) finish_waiting();
}

template <class Real>
void Group<Real>::finish_waiting() {
    if (waiting_.empty()) return;
    finish<Real>(frame_, waiting_, certificate_batch_, hits_, counters_);
    idle_.insert(idle_.end(), waiting_.begin(), waiting_.end());
    waiting_.clear();
}

template <class Real>
void Group<Real>::run() {
    const bool by_range = frame_.stop.rule == StopRule::Delta;
    const Real delta = by_range ? static_cast<Real>(frame_.stop.value) : 0;
    bool more = true;
    for (;;) {
        more = more && refill();
        if (marching_.empty() || frame_.stopped()) break;
        batch_.evaluate(frame_, 2 * marching_.size(), counters_);
        for (const Packet<Real>* const packet : marching_)
            packet->tell_costs(counters_.costs, 2.0);
        // Packets that have a next slice move to the front, with their boxes; the others are done.
        std::size_t slots = 0;
        for (std::size_t i = 0; i < marching_.size(); ++i) {
            Packet<Real>& packet = *marching_[i];
            if (take_answers(packet, i, batch_, delta)) {
                store_halves(packet, slots, batch_);
                marching_[slots++] = &packet;
            } else {
                retire(packet);
            }
        }
        marching_.resize(slots);
    }
    finish_waiting();
    if (more || !marching_.empty()) hits_.leave_undecided(tile_);
}

void trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters) {
    in_precision(frame,
                 [&](auto real) { Group<decltype(real)>(frame, tile, hits, counters).run(); });
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(trace_tile);

void trace_tile_k_bisection(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                            Counters& counters) {
    HWY_DYNAMIC_DISPATCH(trace_tile)(frame, tile, hits, counters);
}

}  // namespace zeroset

#endif
