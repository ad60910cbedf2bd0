// The batch in which packets of K-bisection ask the kernel.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_BATCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_BATCH_INL
#undef ZEROSET_K_BATCH_INL
#else
#define ZEROSET_K_BATCH_INL
#endif

#include "engine/trace/k_packet-inl.hpp"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The boxes of a group of packets, and what the kernel says of them.
struct Batch {
    static constexpr std::size_t capacity = batch_capacity;
    static constexpr std::size_t hi_offset = 3 * capacity;  ///< from -lo to hi, in floats
    static_assert(capacity % batch_multiple == 0);

    alignas(64) float ends[6][capacity];  ///< -lo of x, y, z, then hi of x, y, z
    alignas(64) float f_neg_lo[capacity];
    alignas(64) float f_hi[capacity];
    alignas(64) std::uint32_t continuous[capacity];

    /// Evaluates the first `slots` slots.
    void evaluate(const TraceFrame& frame, std::size_t slots, Counters& counters) {
        const std::size_t used = slots * lanes;
        const std::size_t size = (used + batch_multiple - 1) / batch_multiple * batch_multiple;
        counters.range += used;
        const RangeBatch batch{size,
                               {ends[0], ends[1], ends[2]},
                               {ends[3], ends[4], ends[5]},
                               frame.scene.uniforms.neg_lo_hi.data(),
                               f_neg_lo,
                               f_hi,
                               continuous};
        frame.kernel.range(batch);
    }
};

/// Puts the box of [from, to] of a packet into slot `slot` of the batch.
HWY_INLINE void store_box(const Packet& packet, V from, V to, std::size_t slot, Batch& batch) {
    float* const at = batch.ends[0] + slot * lanes;
    const Axes& axes = *packet.axes;
    hn::Store(hn::Neg(from), d, at + axes.from_offset[0]);
    hn::Store(to, d, at + axes.to_offset[0]);
    for (int i = 1; i < 3; ++i) {
        const Line& line = packet.line[i - 1];
        const V slope = hn::Load(d, line.slope);
        hn::Store(hn::NegMulAdd(slope, from, hn::Load(d, line.neg_lo)), d,
                  at + axes.from_offset[i]);
        hn::Store(hn::MulAdd(slope, to, hn::Load(d, line.hi)), d, at + axes.to_offset[i]);
    }
}

HWY_INLINE M is_continuous(const Batch& batch, std::size_t slot) {
    const auto bits = hn::Load(du, batch.continuous + slot * lanes);
    return hn::RebindMask(d, hn::Ne(bits, hn::Zero(du)));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
