// Earliest zero on a ray by K-bisection [Knoll07, sec. 4 to 5.5 and appendix A].
//   K       the packet's dominant axis, mirrored so that rays go towards +K; U, V the others
//   d_stop  deepest bisection; its cells are 2^-d_stop of the clip box's longest edge
// A packet of rays marches from one K slice to the next; F, the interval extension of f, over the
// box of a slice rejects it, or the slice is halved, down to d_stop.
//
// Differs from the paper:
// - The packet is as wide as the machine's lanes, and a group of packets takes each step together,
//   so that the kernel works on a batch.
// - Slices are cells of the dyadic grid of K (multiples of a power of two), whose ends are exact
//   floats, and the ends' U and V come from one multiply-add each instead of the sum of the
//   increments: sound under upward rounding, and without the error of up to d_stop additions. The
//   stack shrinks to a cell's index and size.
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

constexpr int group_size = 32;  ///< packets a batch

/// The boxes of a group of packets, and what the kernel says of them.
struct Batch {
    static constexpr std::size_t capacity = group_size * lanes;
    static_assert(capacity % batch_multiple == 0);

    alignas(64) float neg_lo[3][capacity];
    alignas(64) float hi[3][capacity];
    alignas(64) float f_neg_lo[capacity];
    alignas(64) float f_hi[capacity];
    alignas(64) std::uint32_t continuous[capacity];

    void evaluate(const Scene& scene, std::size_t packets, Counters& counters) {
        const std::size_t used = packets * lanes;
        const std::size_t size = (used + batch_multiple - 1) / batch_multiple * batch_multiple;
        counters.range += used;
        const RangeBatch batch{size,
                               {neg_lo[0], neg_lo[1], neg_lo[2]},
                               {hi[0], hi[1], hi[2]},
                               scene.uniforms.neg_lo_hi.data(),
                               f_neg_lo,
                               f_hi,
                               continuous};
        scene.kernel.range(batch);
    }

    [[nodiscard]] Sign sign(std::size_t item) const {
        if (f_neg_lo[item] < 0) return Sign::Positive;
        return f_hi[item] < 0 ? Sign::Negative : Sign::Unknown;
    }
};

/// Puts the box of [k_from, k_to] of a packet into slot `slot` of the batch.
HWY_INLINE void store_box(const Packet& packet, V k_from, V k_to, std::size_t slot, Batch& batch) {
    const std::size_t at = slot * lanes;
    const bool mirrored = packet.mirrored;
    hn::Store(mirrored ? k_to : hn::Neg(k_from), d, batch.neg_lo[packet.axis[0]] + at);
    hn::Store(mirrored ? hn::Neg(k_from) : k_to, d, batch.hi[packet.axis[0]] + at);
    for (int i = 0; i < 2; ++i) {
        const Line& line = packet.line[i];
        const V slope = hn::Load(d, line.slope);
        const V hi = hn::Load(d, line.hi);
        const V neg_lo = hn::Load(d, line.neg_lo);
        const V box_hi = hn::Max(hn::MulAdd(slope, k_from, hi), hn::MulAdd(slope, k_to, hi));
        const V box_neg_lo =
            hn::Max(hn::NegMulAdd(slope, k_from, neg_lo), hn::NegMulAdd(slope, k_to, neg_lo));
        hn::Store(box_hi, d, batch.hi[packet.axis[i + 1]] + at);
        hn::Store(box_neg_lo, d, batch.neg_lo[packet.axis[i + 1]] + at);
    }
}

/// Puts the packet's current cell into the batch, stepping over cells that no living ray meets.
/// False when the packet is finished.
HWY_INLINE bool store_cell(Packet& packet, std::size_t slot, Batch& batch) {
    const V k_in = hn::Load(d, packet.k_in);
    const V k_out = hn::Load(d, packet.k_out);
    for (;;) {
        const V start = hn::Set(d, packet.cell_start());
        if (hn::AllFalse(d, hn::Le(start, k_out))) return false;
        const V from = hn::Max(start, k_in);
        const V to = hn::Min(hn::Set(d, packet.cell_end()), k_out);
        if (!hn::AllFalse(d, hn::Le(from, to))) {
            store_box(packet, from, to, slot, batch);
            return true;
        }
        packet.advance();
    }
}

/// Takes the kernel's answer for the packet's current cell and goes to the next one. `delta`: the
/// width of F at which the search stops before d_stop; 0: never.
HWY_INLINE void take_answer(Packet& packet, std::size_t slot, const Batch& batch, float delta) {
    const std::size_t at = slot * lanes;
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V from = hn::Max(hn::Set(d, packet.cell_start()), hn::Load(d, packet.k_in));
    const V to = hn::Min(hn::Set(d, packet.cell_end()), hn::Load(d, packet.k_out));
    const M active = hn::Le(from, to);
    const V f_neg_lo = hn::Load(d, batch.f_neg_lo + at);
    const V f_hi = hn::Load(d, batch.f_hi + at);
    const M above = hn::Lt(f_neg_lo, zero);
    const M below = hn::Lt(f_hi, zero);
    const M rejected = hn::Or(above, below);  // both: f is undefined in the whole cell
    const V side = hn::Sub(hn::IfThenElseZero(above, one), hn::IfThenElseZero(below, one));
    hn::Store(hn::IfThenElse(hn::And(rejected, active), side, hn::Load(d, packet.side)), d,
              packet.side);

    const M candidate = hn::AndNot(rejected, active);
    if (hn::AllFalse(d, candidate)) {
        packet.advance();
        return;
    }
    const M narrow = hn::Lt(hn::Add(f_neg_lo, f_hi), hn::Set(d, delta));
    const M stop = packet.size == 1 ? candidate : hn::And(candidate, narrow);
    if (!hn::AllFalse(d, stop)) {
        const M continuous =
            hn::RebindMask(d, hn::Ne(hn::Load(du, batch.continuous + at), hn::Zero(du)));
        packet.stop_at(hn::And(stop, continuous), hn::AndNot(continuous, stop), from, to);
    }
    if (packet.size > 1 && !hn::AllFalse(d, hn::AndNot(stop, candidate))) {
        packet.descend();
    } else {
        packet.advance();
    }
}

// ---- after the search: certificates ----

/// A stopped ray on its way to a certificate.
struct Bracket {
    float from, to;      ///< K; everything before `from` was rejected
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
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                Bracket& bracket = brackets[p * lanes + lane];
                if (step > 0 && bracket.open) {
                    bracket.inner_from = bracket.to;
                    bracket.to = std::min(bracket.to + packets[p]->unit,
                                          packets[p]->hit_limit[lane]);
                }
                a[lane] = step > 0 ? bracket.inner_from : bracket.from;
                b[lane] = bracket.to;
            }
            const V to = hn::Load(d, b);
            const V from = hn::Load(d, a);
            // The slice itself needs no second look: it is known to be continuous.
            store_box(*packets[p], from, step > 0 ? to : from, 2 * p, batch);
            store_box(*packets[p], to, to, 2 * p + 1, batch);
        }
        batch.evaluate(scene, 2 * packets.size(), counters);
        bool any_open = false;
        for (std::size_t i = 0; i < packets.size() * lanes; ++i) {
            Bracket& bracket = brackets[i];
            if (!bracket.open) continue;
            const std::size_t slot = 2 * (i / lanes) * lanes + i % lanes;
            if (step == 0 && bracket.before == Sign::Unknown) bracket.before = batch.sign(slot);
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
        const auto side = static_cast<Sign>(static_cast<int>(packet.side[lane]));
        brackets[lane] = {from, to, from, side, hit, false};
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
    Batch batch_;
};

bool Group::refill() {
    while (marching_.size() < group_size) {
        if (!source_.next(*idle_.back())) return false;
        marching_.push_back(idle_.back());
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
    finish(frame_.scene, waiting_, batch_, hits_, counters_);
    idle_.insert(idle_.end(), waiting_.begin(), waiting_.end());
    waiting_.clear();
}

void Group::run() {
    const bool by_range = frame_.stop.rule == StopRule::Delta;
    const float delta = by_range ? static_cast<float>(frame_.stop.value) : 0.0F;
    bool more = true;
    while (more || !marching_.empty()) {
        more = more && refill();
        // Packets that have a cell to look at move to the front, the others are done.
        std::size_t slots = 0;
        for (std::size_t i = 0; i < marching_.size(); ++i) {
            if (store_cell(*marching_[i], slots, batch_)) {
                std::swap(marching_[slots++], marching_[i]);
            }
        }
        if (slots > 0) {
            batch_.evaluate(frame_.scene, slots, counters_);
            for (std::size_t slot = 0; slot < slots; ++slot) {
                take_answer(*marching_[slot], slot, batch_, delta);
            }
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
