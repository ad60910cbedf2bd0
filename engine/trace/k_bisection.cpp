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
//   floats computed from the index; their U and V come from one multiply-add each instead of the
//   sum of the increments: sound under upward rounding, and without the error of up to d_stop
//   additions. The stack shrinks to a bit for each right half still to be looked at.
// - U and V are mirrored, too, so that neither falls along K; a ray for which one does makes a
//   packet of its own.
// - Boxes are clipped to the part of the ray inside the clip box and in front of the eye.
// - A slice on which f is not proved continuous is never a hit (the paper's rule for division,
//   where F is infinite); the ray goes on, and its pixel is no longer certified. Where the
//   first one begins is handed on, as it may lie before another surface's hit.
// - Behind a limit of the tile (nearer surfaces of the scene) a ray ends.
// - A hit whose ends have proved opposite signs is certified, any other is undecided.

#include "engine/trace/k_bisection.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/k_bisection.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/k_batch-inl.hpp"
#include "engine/trace/k_certificate-inl.hpp"
#include "engine/trace/k_packet-inl.hpp"
#include "engine/trace/k_packet_source-inl.hpp"
#include "engine/trace/k_patch-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The ends of the halves of a packet's current slice, clipped to each ray.
struct Halves {
    V from, middle, to;
};

HWY_INLINE Halves halves_of(const Packet& packet) {
    const V k_in = hn::Load(d, packet.k_in);
    const V k_out = hn::Load(d, packet.k_out);
    const auto clipped = [&](std::int32_t cell) {
        return hn::Min(hn::Max(hn::Set(d, packet.grid(cell)), k_in), k_out);
    };
    return {clipped(packet.cell), clipped(packet.cell + packet.size / 2),
            clipped(packet.cell + packet.size)};
}

/// Puts the halves of the packet's current slice into the batch.
HWY_INLINE void store_halves(const Packet& packet, std::size_t slot, Batch& batch) {
    const Halves halves = halves_of(packet);
    store_box(packet, halves.from, halves.middle, 2 * slot, batch);
    store_box(packet, halves.middle, halves.to, 2 * slot + 1, batch);
}

/// Living rays on whose box in the slot F does not exclude 0. A ray that does not meet the slice
/// has the box of its entry or exit there.
HWY_INLINE M may_hold_root(const Packet& packet, const Batch& batch, std::size_t slot) {
    const std::size_t at = slot * lanes;
    const V zero = hn::Zero(d);
    const M rejected = hn::Or(hn::Lt(hn::Load(d, batch.f_neg_lo + at), zero),
                              hn::Lt(hn::Load(d, batch.f_hi + at), zero));
    return hn::AndNot(rejected, hn::MaskFromVec(hn::Load(d, packet.alive)));
}

HWY_INLINE M is_narrow(const Batch& batch, std::size_t slot, float delta) {
    const std::size_t at = slot * lanes;
    const V width = hn::Add(hn::Load(d, batch.f_neg_lo + at), hn::Load(d, batch.f_hi + at));
    return hn::Lt(width, hn::Set(d, delta));
}

/// Rays that may hold a root in the halves of a slice.
struct Candidates {
    M left, right;
};

/// Ends the rays whose search stops in the packet's current slice: at d_stop all that may hold a
/// root, before only where F is narrower than delta. The others remain candidates.
Candidates stop_rays(Packet& packet, const Candidates& found, std::size_t slot, const Batch& batch,
                     float delta) {
    const bool finest = packet.size == 2;
    const M left_continuous = is_continuous(batch, slot);
    const M right_continuous = is_continuous(batch, slot + 1);
    const auto stopped = [&](M candidates, M continuous, std::size_t at) {
        if (finest) return candidates;
        return hn::And(candidates, hn::And(continuous, is_narrow(batch, at, delta)));
    };
    const M left_stop = stopped(found.left, left_continuous, slot);
    const M left_hit = hn::And(left_stop, left_continuous);
    // A ray may end in the right half only if it has no root to look for in the left one.
    const M right_stop = hn::AndNot(finest ? left_hit : found.left,
                                    stopped(found.right, right_continuous, slot + 1));
    const M right_hit = hn::And(right_stop, right_continuous);
    const Halves halves = halves_of(packet);
    packet.stop_at(left_hit, halves.from, halves.middle);
    packet.stop_at(right_hit, halves.middle, halves.to);
    const M left_gap = hn::AndNot(left_continuous, left_stop);
    const M right_gap = hn::AndNot(right_continuous, right_stop);
    packet.pass_gap(hn::Or(left_gap, right_gap),
                    hn::IfThenElse(left_gap, halves.from, halves.middle));
    const M ended = hn::Or(left_hit, right_hit);
    return {hn::AndNot(ended, found.left), hn::AndNot(ended, found.right)};
}

/// Takes the kernel's answers for the packet's current slice and goes on; false when the packet is
/// finished. `delta`: the width of F at which the search stops before d_stop; 0: never.
HWY_INLINE bool take_answers(Packet& packet, std::size_t slot, const Batch& batch, float delta) {
    Candidates found{may_hold_root(packet, batch, 2 * slot),
                     may_hold_root(packet, batch, 2 * slot + 1)};
    const bool finest = packet.size == 2;
    if (finest || delta > 0) {
        if (!hn::AllFalse(d, hn::Or(found.left, found.right))) {
            found = stop_rays(packet, found, 2 * slot, batch, delta);
            if (hn::AllFalse(d, hn::MaskFromVec(hn::Load(d, packet.alive)))) return false;
        }
        if (finest) return packet.pop();
    }
    return packet.go_on(!hn::AllFalse(d, found.left), !hn::AllFalse(d, found.right));
}

/// Hands on the rays of a finished packet that passed a slice where f is not continuous.
void push_unsettled(const Packet& packet, TileHits& hits) {
    constexpr float shrink = 1.0F - 0x1p-20F;  // above the rounding errors of `stretch`
    const float eye = float_above(packet.axes->eye[0]);
    for (unsigned bits = packet.unsettled; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        const float behind = eye - packet.gap_from[lane];  // rounded upward
        const float depth = -(behind * packet.stretch[lane]) * shrink;
        hits.unsettled.push_back({packet.pixel(lane), std::max(depth, 0.0F)});
    }
}

/// The packets of a tile that march, and those that wait for their certificates.
class Group {
public:
    Group(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters)
        : frame_(frame),
          source_(frame, tile),
          patches_(frame, tile, source_, batch_, counters),
          hits_(hits),
          counters_(counters) {
        for (Packet& packet : packets_)
            idle_.push_back(&packet);
    }

    void run();

private:
    /// Tops up the marching packets; false when the tile has no more.
    bool refill();
    void retire(Packet& packet);
    void finish_waiting();

    const TraceFrame& frame_;
    Batch batch_{};            ///< slots 2i, 2i + 1: the slice of marching_[i]
    Batch certificate_batch_;  ///< of the waiting packets
    PacketSource source_;
    PatchSlices patches_;
    TileHits& hits_;
    Counters& counters_;
    std::array<Packet, 2 * group_size> packets_;
    std::vector<Packet*> idle_, marching_, waiting_;
};

bool Group::refill() {
    while (marching_.size() < group_size) {
        Packet& packet = *idle_.back();
        if (!source_.next(packet)) return false;
        packet.slices &= patches_.of(packet);
        if (!packet.pop()) continue;
        store_halves(packet, marching_.size(), batch_);
        marching_.push_back(&packet);
        idle_.pop_back();
    }
    return true;
}

/// A packet whose rays have all ended.
void Group::retire(Packet& packet) {
    push_unsettled(packet, hits_);
    if (packet.hit == 0) {
        idle_.push_back(&packet);
        return;
    }
    waiting_.push_back(&packet);
    if (waiting_.size() == group_size) finish_waiting();
}

void Group::finish_waiting() {
    if (waiting_.empty()) return;
    finish(frame_, waiting_, certificate_batch_, hits_, counters_);
    idle_.insert(idle_.end(), waiting_.begin(), waiting_.end());
    waiting_.clear();
}

void Group::run() {
    const bool by_range = frame_.stop.rule == StopRule::Delta;
    const float delta = by_range ? static_cast<float>(frame_.stop.value) : 0.0F;
    bool more = true;
    for (;;) {
        more = more && refill();
        if (marching_.empty()) break;
        batch_.evaluate(frame_, 2 * marching_.size(), counters_);
        // Packets that have a next slice move to the front, with their boxes; the others are done.
        std::size_t slots = 0;
        for (std::size_t i = 0; i < marching_.size(); ++i) {
            Packet& packet = *marching_[i];
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
}

void trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters) {
    Group(frame, tile, hits, counters).run();
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
