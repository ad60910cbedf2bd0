// Certificates for the rays that K-bisection stopped.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_CERTIFICATE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_CERTIFICATE_INL
#undef ZEROSET_K_CERTIFICATE_INL
#else
#define ZEROSET_K_CERTIFICATE_INL
#endif

#include "engine/trace/k_batch-inl.hpp"
#include "engine/trace/tolerance.hpp"

#include <array>
#include <bit>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The stopped rays of a packet on their way to certificates; other rays are carried along.
struct Brackets {
    alignas(vector_bytes) float from[lanes];       ///< K; everything before it was rejected
    alignas(vector_bytes) float to[lanes];         ///< the sign change is looked for up to here
    alignas(vector_bytes) float before[lanes];     ///< sign of f at the hit's start; 0: unknown
    alignas(vector_bytes) float open[lanes];       ///< mask: still to be decided
    alignas(vector_bytes) float certified[lanes];  ///< mask: the sign changes in [from, to]
};

/// +1 or -1 where the enclosure in the slot proves a sign, else 0 (undefined f too).
HWY_INLINE V sign_in(const Batch& batch, std::size_t slot) {
    const V one = hn::Set(d, 1.0F);
    const V zero = hn::Zero(d);
    const V above =
        hn::IfThenElseZero(hn::Lt(hn::Load(d, batch.f_neg_lo + slot * lanes), zero), one);
    const V below = hn::IfThenElseZero(hn::Lt(hn::Load(d, batch.f_hi + slot * lanes), zero), one);
    return hn::Sub(above, below);
}

/// Boxes of the first look: the slice before the hit, which was rejected, so that its sign is that
/// at the hit's start; and the point at the hit's end. The hit itself is known to be continuous.
HWY_INLINE void store_first_look(const Packet& packet, Brackets& brackets, std::size_t slot,
                                 Batch& batch) {
    const V from = hn::Load(d, packet.hit_from);
    const V to = hn::Load(d, packet.hit_to);
    const V k_in = hn::Load(d, packet.k_in);
    const V before = hn::Max(hn::Sub(from, hn::Set(d, packet.unit)), k_in);
    hn::Store(from, d, brackets.from);
    hn::Store(to, d, brackets.to);
    hn::Store(hn::VecFromMask(d, mask_of(packet.hit)), d, brackets.open);
    hn::Store(hn::Zero(d), d, brackets.certified);
    store_box(packet, before, from, slot, batch);
    store_box(packet, to, to, slot + 1, batch);
}

/// Boxes of a further look: the slice behind, and the point at its end.
HWY_INLINE void store_next_look(const Packet& packet, Brackets& brackets, std::size_t slot,
                                Batch& batch) {
    const M open = hn::MaskFromVec(hn::Load(d, brackets.open));
    const V old_to = hn::Load(d, brackets.to);
    const V next = hn::Min(hn::Add(old_to, hn::Set(d, packet.unit)), hn::Load(d, packet.k_out));
    const V from = hn::IfThenElse(open, old_to, hn::Load(d, brackets.from));
    const V to = hn::IfThenElse(open, next, old_to);
    hn::Store(from, d, brackets.from);
    hn::Store(to, d, brackets.to);
    store_box(packet, from, to, slot, batch);
    store_box(packet, to, to, slot + 1, batch);
}

/// Certifies open rays whose sign is opposite behind; false when none is left open.
HWY_INLINE bool take_look(Brackets& brackets, bool first, std::size_t slot, const Batch& batch) {
    M usable = hn::MaskFromVec(hn::Load(d, brackets.open));
    if (first) {
        hn::Store(sign_in(batch, slot), d, brackets.before);
    } else {
        const M grown = hn::Lt(hn::Load(d, brackets.from), hn::Load(d, brackets.to));
        usable = hn::And(usable, hn::And(is_continuous(batch, slot), grown));
    }
    const V before = hn::Load(d, brackets.before);
    usable = hn::And(usable, hn::Ne(before, hn::Zero(d)));
    const M opposite = hn::Eq(sign_in(batch, slot + 1), hn::Neg(before));
    const M now = hn::And(usable, opposite);
    const M certified = hn::Or(hn::MaskFromVec(hn::Load(d, brackets.certified)), now);
    const M open = hn::AndNot(now, usable);
    hn::Store(hn::VecFromMask(d, certified), d, brackets.certified);
    hn::Store(hn::VecFromMask(d, open), d, brackets.open);
    return !hn::AllFalse(d, open);
}

/// Certifies the rays of up to group_size packets that stopped at a root: looks for the opposite
/// sign at the end of the slice, then slice by slice behind it.
void certify(const TraceFrame& frame, std::span<Packet* const> packets,
             std::span<Brackets> brackets, Batch& batch, Counters& counters) {
    for (int step = 0; step <= extra_slices; ++step) {
        for (std::size_t p = 0; p < packets.size(); ++p) {
            if (step == 0) {
                store_first_look(*packets[p], brackets[p], 2 * p, batch);
            } else {
                store_next_look(*packets[p], brackets[p], 2 * p, batch);
            }
        }
        batch.evaluate(frame, 2 * packets.size(), counters);
        bool any_open = false;
        for (std::size_t p = 0; p < packets.size(); ++p) {
            any_open |= take_look(brackets[p], step == 0, 2 * p, batch);
        }
        if (!any_open) return;
    }
}

/// Hands on the hits of a packet, each at the middle of where its sign changes or its search
/// stopped.
void push_hits(const Packet& packet, const Brackets& brackets, TileHits& hits) {
    const M certified = hn::MaskFromVec(hn::Load(d, brackets.certified));
    const V from =
        hn::IfThenElse(certified, hn::Load(d, brackets.from), hn::Load(d, packet.hit_from));
    const V to = hn::IfThenElse(certified, hn::Load(d, brackets.to), hn::Load(d, packet.hit_to));
    const V half = hn::Set(d, 0.5F);
    const V k = hn::MulAdd(half, from, hn::Mul(half, to));
    alignas(vector_bytes) float position[3][lanes];
    alignas(vector_bytes) float depth[lanes];
    const Axes& axes = *packet.axes;
    hn::Store(axes.mirrored[0] ? hn::Neg(k) : k, d, position[axes.world[0]]);
    for (int i = 0; i < 2; ++i) {
        const Line& line = packet.line[i];
        const V middle = hn::Sub(hn::Load(d, line.hi), hn::Load(d, line.neg_lo));
        const V u = hn::MulAdd(hn::Load(d, line.slope), k, hn::Mul(half, middle));
        hn::Store(axes.mirrored[i + 1] ? hn::Neg(u) : u, d, position[axes.world[i + 1]]);
    }
    const V along = hn::Sub(k, hn::Set(d, static_cast<float>(axes.eye[0])));
    hn::Store(hn::Mul(along, hn::Load(d, packet.stretch)), d, depth);
    const unsigned settled = Packet::bits_of(certified) & ~packet.unsettled;
    for (unsigned bits = packet.hit; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        hits.push(packet.pixel(lane), {position[0][lane], position[1][lane], position[2][lane]},
                  depth[lane],
                  (settled >> lane & 1U) != 0 ? Certificate::Certified : Certificate::Undecided);
    }
}

/// Certifies finished packets and hands on what they found.
void finish(const TraceFrame& frame, std::span<Packet* const> packets, Batch& batch, TileHits& hits,
            Counters& counters) {
    std::array<Brackets, group_size> brackets;
    certify(frame, packets, brackets, batch, counters);
    for (std::size_t p = 0; p < packets.size(); ++p)
        push_hits(*packets[p], brackets[p], hits);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
