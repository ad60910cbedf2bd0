// Certificates for the rays that K-bisection stopped.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_CERTIFICATE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_CERTIFICATE_INL
#undef ZEROSET_K_CERTIFICATE_INL
#else
#define ZEROSET_K_CERTIFICATE_INL
#endif

#include "engine/scene/tolerance.hpp"
#include "engine/trace/k_bisection/k_batch-inl.hpp"

#include <array>
#include <bit>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The stopped rays of a packet on their way to certificates; other rays are carried along.
template <class Real>
struct Brackets {
    alignas(vector_bytes<Real>) Real from[lanes<Real>];  ///< K; everything before it was rejected
    alignas(vector_bytes<Real>) Real to[lanes<Real>];  ///< the sign change is looked for up to here
    alignas(
        vector_bytes<Real>) Real before[lanes<Real>];  ///< sign of f at the hit's start; 0: unknown
    alignas(vector_bytes<Real>) Real open[lanes<Real>];  ///< mask: still to be decided
    alignas(
        vector_bytes<Real>) Real certified[lanes<Real>];  ///< mask: the sign changes in [from, to]
};

/// +1 or -1 where the enclosure in the slot proves a sign, else 0 (undefined f too).
template <class Real>
HWY_INLINE V<Real> sign_in(const Batch<Real>& batch, std::size_t slot) {
    const V<Real> one = hn::Set(d<Real>, Real{1});
    const V<Real> zero = hn::Zero(d<Real>);
    const V<Real> above = hn::IfThenElseZero(
        hn::Lt(hn::Load(d<Real>, batch.f_neg_lo + slot * lanes<Real>), zero), one);
    const V<Real> below =
        hn::IfThenElseZero(hn::Lt(hn::Load(d<Real>, batch.f_hi + slot * lanes<Real>), zero), one);
    return hn::Sub(above, below);
}

/// Stores the boxes of the first look: the slice before the hit, which was rejected, so that its
/// sign is that at the hit's start; and the point at the hit's end. The hit itself is known to be
/// continuous.
template <class Real>
HWY_INLINE void store_first_look(const Packet<Real>& packet, Brackets<Real>& brackets,
                                 std::size_t slot, Batch<Real>& batch) {
    const V<Real> from = hn::Load(d<Real>, packet.hit_from);
    const V<Real> to = hn::Load(d<Real>, packet.hit_to);
    const V<Real> k_in = hn::Load(d<Real>, packet.k_in);
    const V<Real> before = hn::Max(hn::Sub(from, hn::Set(d<Real>, packet.look)), k_in);
    hn::Store(from, d<Real>, brackets.from);
    hn::Store(to, d<Real>, brackets.to);
    hn::Store(hn::VecFromMask(d<Real>, mask_of(d<Real>, packet.hit)), d<Real>, brackets.open);
    hn::Store(hn::Zero(d<Real>), d<Real>, brackets.certified);
    store_box(packet, before, from, slot, batch);
    store_box(packet, to, to, slot + 1, batch);
}

/// Stores the boxes of a further look: the slice behind, and the point at its end.
template <class Real>
HWY_INLINE void store_next_look(const Packet<Real>& packet, Brackets<Real>& brackets,
                                std::size_t slot, Batch<Real>& batch) {
    const M<Real> open = hn::MaskFromVec(hn::Load(d<Real>, brackets.open));
    const V<Real> old_to = hn::Load(d<Real>, brackets.to);
    const V<Real> next =
        hn::Min(hn::Add(old_to, hn::Set(d<Real>, packet.look)), hn::Load(d<Real>, packet.k_out));
    const V<Real> from = hn::IfThenElse(open, old_to, hn::Load(d<Real>, brackets.from));
    const V<Real> to = hn::IfThenElse(open, next, old_to);
    hn::Store(from, d<Real>, brackets.from);
    hn::Store(to, d<Real>, brackets.to);
    store_box(packet, from, to, slot, batch);
    store_box(packet, to, to, slot + 1, batch);
}

/// Certifies open rays whose sign is opposite behind; false when none is left open.
template <class Real>
HWY_INLINE bool take_look(Brackets<Real>& brackets, bool first, std::size_t slot,
                          const Batch<Real>& batch) {
    // Learn the sign before the hit, later whether f is continuous in what the bracket grew by.
    M<Real> usable = hn::MaskFromVec(hn::Load(d<Real>, brackets.open));
    if (first) {
        hn::Store(sign_in(batch, slot), d<Real>, brackets.before);
    } else {
        const M<Real> grown =
            hn::Lt(hn::Load(d<Real>, brackets.from), hn::Load(d<Real>, brackets.to));
        usable = hn::And(usable, hn::And(is_continuous(batch, slot), grown));
    }
    // Certify where the sign behind is the opposite one; give up where the first one is not known.
    const V<Real> before = hn::Load(d<Real>, brackets.before);
    usable = hn::And(usable, hn::Ne(before, hn::Zero(d<Real>)));
    const M<Real> opposite = hn::Eq(sign_in(batch, slot + 1), hn::Neg(before));
    const M<Real> now = hn::And(usable, opposite);
    const M<Real> certified = hn::Or(hn::MaskFromVec(hn::Load(d<Real>, brackets.certified)), now);
    const M<Real> open = hn::AndNot(now, usable);
    hn::Store(hn::VecFromMask(d<Real>, certified), d<Real>, brackets.certified);
    hn::Store(hn::VecFromMask(d<Real>, open), d<Real>, brackets.open);
    return !hn::AllFalse(d<Real>, open);
}

/// Certifies the rays of up to group_size packets that stopped at a root: looks for the opposite
/// sign at the end of the slice, then slice by slice behind it.
template <class Real>
void certify(const TraceFrame& frame, std::span<Packet<Real>* const> packets,
             std::span<Brackets<Real>> brackets, Batch<Real>& batch, Counters& counters) {
    for (int step = 0; step <= extra_slices; ++step) {
        for (std::size_t p = 0; p < packets.size(); ++p) {
            if (step == 0) {
                store_first_look(*packets[p], brackets[p], 2 * p, batch);
            } else {
                store_next_look(*packets[p], brackets[p], 2 * p, batch);
            }
        }
        batch.evaluate(frame, 2 * packets.size(), counters);
        for (const Packet<Real>* const packet : packets)
            packet->tell_costs(counters.costs, 2.0);
        bool any_open = false;
        for (std::size_t p = 0; p < packets.size(); ++p) {
            any_open |= take_look(brackets[p], step == 0, 2 * p, batch);
        }
        if (!any_open) return;
    }
}

/// Hands on the hits of a packet, each at the middle of where its sign changes or its search
/// stopped.
template <class Real>
void push_hits(const Packet<Real>& packet, const Brackets<Real>& brackets, TileHits& hits) {
    // Take the bracket of the sign change where there is one, else where the search stopped.
    const M<Real> certified = hn::MaskFromVec(hn::Load(d<Real>, brackets.certified));
    const V<Real> from = hn::IfThenElse(certified, hn::Load(d<Real>, brackets.from),
                                        hn::Load(d<Real>, packet.hit_from));
    const V<Real> to =
        hn::IfThenElse(certified, hn::Load(d<Real>, brackets.to), hn::Load(d<Real>, packet.hit_to));
    // Compute the points in the middle, and their distances.
    const V<Real> half = number<Real>(0.5);
    const V<Real> k = hn::MulAdd(half, from, hn::Mul(half, to));
    alignas(vector_bytes<Real>) Real position[3][lanes<Real>];
    alignas(vector_bytes<Real>) Real depth[lanes<Real>];
    const Axes<Real>& axes = *packet.axes;
    hn::Store(axes.mirrored[0] ? hn::Neg(k) : k, d<Real>, position[axes.world[0]]);
    for (int i = 0; i < 2; ++i) {
        const AxisLines<Real>& line = packet.line[i];
        const V<Real> middle = hn::Sub(hn::Load(d<Real>, line.hi), hn::Load(d<Real>, line.neg_lo));
        const V<Real> slopes =
            hn::Add(hn::Load(d<Real>, line.slope_lo), hn::Load(d<Real>, line.slope_hi));
        const V<Real> u = hn::MulAdd(hn::Mul(half, slopes), k, hn::Mul(half, middle));
        hn::Store(axes.mirrored[i + 1] ? hn::Neg(u) : u, d<Real>, position[axes.world[i + 1]]);
    }
    const V<Real> along = hn::Sub(k, hn::Load(d<Real>, packet.k_start));
    const V<Real> first = number<Real>(axes.start_depth);
    hn::Store(hn::MulAdd(along, hn::Load(d<Real>, packet.stretch), first), d<Real>, depth);
    // Push the hits; nothing is certified behind an unsettled cell.
    const unsigned settled = axes.certifies ? bits_of(d<Real>, certified) & ~packet.unsettled : 0;
    for (unsigned bits = packet.hit; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        hits.push(packet.pixel(lane),
                  {static_cast<double>(position[0][lane]), static_cast<double>(position[1][lane]),
                   static_cast<double>(position[2][lane])},
                  static_cast<float>(depth[lane]),
                  (settled >> lane & 1U) != 0 ? Certificate::Certified : Certificate::Undecided);
    }
}

/// Certifies finished packets and hands on what they found.
template <class Real>
void finish(const TraceFrame& frame, std::span<Packet<Real>* const> packets, Batch<Real>& batch,
            TileHits& hits, Counters& counters) {
    std::array<Brackets<Real>, group_size> brackets;
    certify<Real>(frame, packets, brackets, batch, counters);
    for (std::size_t p = 0; p < packets.size(); ++p)
        push_hits(*packets[p], brackets[p], hits);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
