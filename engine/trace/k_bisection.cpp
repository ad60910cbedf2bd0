// Earliest zero on a ray by K-bisection [Knoll07, sec. 4 to 5.5 and appendix A].
//   K       the packet's dominant axis, mirrored so that rays go towards +K; U, V the others
//   d_stop  deepest bisection; its cells are 2^-d_stop of the clip box's longest edge
// A packet of rays marches from one K slice to the next; F, the interval extension of f, over the
// box of a slice rejects it, or the slice is halved, down to d_stop.
//
// Differs from the paper:
// - The packet is as wide as the machine's lanes, and a group of packets takes each step together,
//   so that the kernel works on a batch.
// - Slices are cells of one grid of the clip box, 2^d_stop to its longest edge, whose ends are
//   floats computed from the index; their U and V come from one multiply-add each instead of the
//   sum of the increments: sound under upward rounding, and without the error of up to d_stop
//   additions. The stack shrinks to a cell's index and size.
// - Boxes are clipped to the part of the ray inside the clip box and in front of the eye.
// - A slice on which f is not proved continuous is never a hit (the paper's rule for division,
//   where F is infinite); the ray goes on, and its pixel is no longer certified.
// - A hit whose ends have proved opposite signs is certified, any other is undecided.

#include "engine/trace/k_bisection.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/k_bisection.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "engine/trace/k_packet-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {


/// The boxes of a group of packets, and what the kernel says of them.
struct Batch {
    static constexpr std::size_t capacity = batch_capacity;
    static constexpr std::size_t hi_offset = 3 * capacity;  ///< from -lo to hi, in floats
    static_assert(capacity % batch_multiple == 0);

    alignas(64) float ends[6][capacity];  ///< -lo of x, y, z, then hi of x, y, z
    alignas(64) float active[capacity];   ///< mask: rays that meet their slice
    alignas(64) float f_neg_lo[capacity];
    alignas(64) float f_hi[capacity];
    alignas(64) std::uint32_t continuous[capacity];

    void evaluate(const Scene& scene, std::size_t packets, Counters& counters) {
        const std::size_t used = packets * lanes;
        const std::size_t size = (used + batch_multiple - 1) / batch_multiple * batch_multiple;
        counters.range += used;
        const RangeBatch batch{size,
                               {ends[0], ends[1], ends[2]},
                               {ends[3], ends[4], ends[5]},
                               scene.uniforms.neg_lo_hi.data(),
                               f_neg_lo,
                               f_hi,
                               continuous};
        scene.kernel.range(batch);
    }

    [[nodiscard]] Sign sign(std::size_t item) const {
        if ((f_neg_lo[item] < 0) == (f_hi[item] < 0)) return Sign::Unknown;  // or undefined
        return f_neg_lo[item] < 0 ? Sign::Positive : Sign::Negative;
    }
};

/// Puts the box of [k_from, k_to] of a packet into slot `slot` of the batch.
HWY_INLINE void store_box(const Packet& packet, V k_from, V k_to, std::size_t slot, Batch& batch) {
    float* const at = batch.ends[0] + slot * lanes;
    hn::Store(hn::Neg(k_from), d, at + packet.k_from_offset);
    hn::Store(k_to, d, at + packet.k_to_offset);
    for (const Line& line : packet.line) {
        const V slope = hn::Load(d, line.slope);
        const V hi = hn::Load(d, line.hi);
        const V neg_lo = hn::Load(d, line.neg_lo);
        const V box_hi = hn::Max(hn::MulAdd(slope, k_from, hi), hn::MulAdd(slope, k_to, hi));
        const V box_neg_lo =
            hn::Max(hn::NegMulAdd(slope, k_from, neg_lo), hn::NegMulAdd(slope, k_to, neg_lo));
        hn::Store(box_neg_lo, d, at + line.neg_lo_offset);
        hn::Store(box_hi, d, at + line.neg_lo_offset + Batch::hi_offset);
    }
}

/// Puts the packet's current slice into the batch, stepping over slices that no living ray meets.
/// False when the packet is finished.
HWY_INLINE bool store_slice(Packet& packet, std::size_t slot, Batch& batch) {
    const V k_in = hn::Load(d, packet.k_in);
    const V k_out = hn::Load(d, packet.k_out);
    for (;;) {
        const V start = hn::Set(d, packet.cell_start());
        const V from = hn::Max(start, k_in);
        const V to = hn::Min(hn::Set(d, packet.cell_end()), k_out);
        const M active = hn::Le(from, to);
        if (!hn::AllFalse(d, active)) {
            hn::Store(hn::VecFromMask(d, active), d, batch.active + slot * lanes);
            // Rays that do not meet the slice get some box of it: infinite arguments are slow.
            store_box(packet, hn::IfThenElse(active, from, start),
                      hn::IfThenElse(active, to, start), slot, batch);
            return true;
        }
        if (hn::AllFalse(d, hn::Le(start, k_out))) return false;
        packet.go_on(false);
    }
}

/// Takes the kernel's answer for the packet's current slice and goes to the next one. `delta`: the
/// width of F at which the search stops before d_stop; 0: never.
HWY_INLINE void take_answer(Packet& packet, std::size_t slot, const Batch& batch, float delta) {
    const std::size_t at = slot * lanes;
    const V zero = hn::Zero(d);
    const V f_neg_lo = hn::Load(d, batch.f_neg_lo + at);
    const V f_hi = hn::Load(d, batch.f_hi + at);
    const M rejected = hn::Or(hn::Lt(f_neg_lo, zero), hn::Lt(f_hi, zero));
    const M candidate = hn::AndNot(rejected, hn::MaskFromVec(hn::Load(d, batch.active + at)));
    M undecided = candidate;
    if (packet.size == 1 || delta > 0) {
        const M narrow = hn::Lt(hn::Add(f_neg_lo, f_hi), hn::Set(d, delta));
        const M stop = packet.size == 1 ? candidate : hn::And(candidate, narrow);
        undecided = hn::AndNot(stop, candidate);
        if (!hn::AllFalse(d, stop)) {
            const M continuous =
                hn::RebindMask(d, hn::Ne(hn::Load(du, batch.continuous + at), hn::Zero(du)));
            packet.stop_at(hn::And(stop, continuous), hn::AndNot(continuous, stop));
        }
    }
    packet.go_on(!hn::AllFalse(d, undecided));
}

// ---- after the search: certificates ----

/// A stopped ray on its way to a certificate.
struct Bracket {
    float before_from;   ///< K; start of a slice that was rejected, up to `from`
    float from, to;      ///< everything before `from` was rejected
    float inner_from;    ///< the sign change is proved between inner_from and `to`
    Sign before;         ///< of f at `from`
    bool open;           ///< still to be decided
    bool certified;
};

/// How many further slices are looked at behind the one where the search stopped.
constexpr int extra_slices = 3;

/// Certifies the rays of up to group_size / 2 packets that stopped at a root: looks for the
/// opposite sign at the end of the slice, then slice by slice behind it.
void certify(const Scene& scene, std::span<Packet* const> packets,
             std::span<Bracket> brackets, Batch& batch, Counters& counters) {
    for (int step = 0; step <= extra_slices; ++step) {
        for (std::size_t p = 0; p < packets.size(); ++p) {
            alignas(64) float a[lanes];
            alignas(64) float b[lanes];
            alignas(64) float end[lanes];
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                Bracket& bracket = brackets[p * lanes + lane];
                if (step > 0 && bracket.open) {
                    bracket.inner_from = bracket.to;
                    bracket.to = std::min(bracket.to + packets[p]->unit,
                                          packets[p]->hit_limit[lane]);
                }
                // First the slice before the hit: it was rejected, so its sign is that at the
                // hit's start. The hit's own slice is known to be continuous.
                a[lane] = step > 0 ? bracket.inner_from : bracket.before_from;
                b[lane] = step > 0 ? bracket.to : bracket.from;
                end[lane] = bracket.to;
            }
            store_box(*packets[p], hn::Load(d, a), hn::Load(d, b), 2 * p, batch);
            store_box(*packets[p], hn::Load(d, end), hn::Load(d, end), 2 * p + 1, batch);
        }
        batch.evaluate(scene, 2 * packets.size(), counters);
        bool any_open = false;
        for (std::size_t i = 0; i < packets.size() * lanes; ++i) {
            Bracket& bracket = brackets[i];
            if (!bracket.open) continue;
            const std::size_t slot = 2 * (i / lanes) * lanes + i % lanes;
            if (step == 0) bracket.before = batch.sign(slot);
            const Sign after = batch.sign(slot + lanes);
            const bool usable = bracket.before != Sign::Unknown &&
                                (step == 0 || (batch.continuous[slot] != 0 &&
                                               bracket.to > bracket.inner_from));
            bracket.certified = usable && after != Sign::Unknown && after != bracket.before;
            bracket.open = usable && !bracket.certified;
            any_open = any_open || bracket.open;
        }
        if (!any_open) return;
    }
}

void open_brackets(const Packet& packet, std::span<Bracket> brackets) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const bool hit = (packet.hit >> lane & 1U) != 0;
        const float from = hit ? packet.hit_from[lane] : 0.0F;
        const float to = hit ? packet.hit_to[lane] : 0.0F;
        const float before = hit ? std::max(from - packet.unit, packet.hit_start[lane]) : 0.0F;
        brackets[lane] = {before, from, to, from, Sign::Unknown, hit, false};
    }
}

/// The hit of one ray, at the middle of where its sign change or its last slice is.
void push_hit(const Packet& packet, std::size_t lane, const Bracket& bracket, TileHits& hits) {
    const float from = bracket.certified ? bracket.inner_from : packet.hit_from[lane];
    const float to = bracket.certified ? bracket.to : packet.hit_to[lane];
    const float k = 0.5F * from + 0.5F * to;
    std::array<float, 3> position{};
    position[static_cast<std::size_t>(packet.axis[0])] = packet.mirrored ? -k : k;
    for (std::size_t i = 0; i < 2; ++i) {
        const Line& line = packet.line[i];
        position[static_cast<std::size_t>(packet.axis[i + 1])] =
            line.slope[lane] * k + 0.5F * (line.hi[lane] - line.neg_lo[lane]);
    }
    const double depth = (double{k} - packet.k_eye) * double{packet.stretch[lane]};
    const bool settled = bracket.certified && (packet.unsettled >> lane & 1U) == 0;
    const auto pixel_col = packet.col + static_cast<int>(lane) % block_cols;
    const auto pixel_row = packet.row + static_cast<int>(lane) / block_cols;
    hits.push({static_cast<std::int16_t>(pixel_col), static_cast<std::int16_t>(pixel_row)},
              position, static_cast<float>(depth),
              settled ? Certificate::Certified : Certificate::Undecided);
}

/// Certifies finished packets and hands on what they found.
void finish(const Scene& scene, std::span<Packet* const> packets, Batch& batch, TileHits& hits,
            Counters& counters) {
    std::array<Bracket, group_size / 2 * lanes> brackets;
    for (std::size_t p = 0; p < packets.size(); ++p) {
        open_brackets(*packets[p], std::span(brackets).subspan(p * lanes, lanes));
    }
    certify(scene, packets, brackets, batch, counters);
    for (std::size_t i = 0; i < packets.size() * lanes; ++i) {
        const Packet& packet = *packets[i / lanes];
        if ((packet.hit >> (i % lanes) & 1U) != 0) push_hit(packet, i % lanes, brackets[i], hits);
    }
}

/// The packets of a tile that march, and those that wait for their certificates.
class Group {
public:
    Group(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters)
        : frame_(frame), source_(frame, tile), hits_(hits), counters_(counters) {
        for (Packet& packet : packets_) idle_.push_back(&packet);
    }

    void run();

private:
    /// Tops up the marching packets; false when the tile has no more.
    bool refill();
    void retire(Packet& packet);
    void finish_waiting();

    const TraceFrame& frame_;
    PacketSource source_;
    TileHits& hits_;
    Counters& counters_;
    std::array<Packet, group_size + group_size / 2> packets_;
    std::vector<Packet*> idle_, marching_, waiting_;
    Batch batch_;              ///< slot i: the current slice of marching_[i]
    Batch certificate_batch_;  ///< of the waiting packets
};

bool Group::refill() {
    while (marching_.size() < group_size) {
        Packet& packet = *idle_.back();
        if (!source_.next(packet)) return false;
        if (!store_slice(packet, marching_.size(), batch_)) continue;
        marching_.push_back(&packet);
        idle_.pop_back();
    }
    return true;
}

/// A packet whose rays have all ended.
void Group::retire(Packet& packet) {
    for (unsigned bits = packet.unsettled & ~packet.hit; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        hits_.unsettled.push_back({static_cast<std::int16_t>(packet.col + lane % block_cols),
                                   static_cast<std::int16_t>(packet.row + lane / block_cols)});
    }
    if (packet.hit == 0) {
        idle_.push_back(&packet);
        return;
    }
    waiting_.push_back(&packet);
    if (waiting_.size() == group_size / 2) finish_waiting();
}

void Group::finish_waiting() {
    if (waiting_.empty()) return;
    finish(frame_.scene, waiting_, certificate_batch_, hits_, counters_);
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
        batch_.evaluate(frame_.scene, marching_.size(), counters_);
        // Packets that have a next slice move to the front, with their boxes; the others are done.
        std::size_t slots = 0;
        for (std::size_t i = 0; i < marching_.size(); ++i) {
            Packet& packet = *marching_[i];
            take_answer(packet, i, batch_, delta);
            if (store_slice(packet, slots, batch_)) std::swap(marching_[slots++], marching_[i]);
        }
        while (marching_.size() > slots) {
            Packet& done = *marching_.back();
            marching_.pop_back();
            retire(done);
        }
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
