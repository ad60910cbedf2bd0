// The batch in which packets of K-bisection ask the kernel.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_K_BATCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_K_BATCH_INL
#undef ZEROSET_K_BATCH_INL
#else
#define ZEROSET_K_BATCH_INL
#endif

#include "engine/kernel/range_boxes.hpp"
#include "engine/trace/k_bisection/k_packet-inl.hpp"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// The boxes of a group of packets, and what the kernel says of them.
template <class Real>
struct Batch : RangeBoxes<Real, batch_capacity<Real>> {
    /// Evaluates the first `slots` slots.
    void evaluate(const TraceFrame& frame, std::size_t slots, Counters& counters) {
        const std::size_t used = slots * lanes<Real>;
        counters.range += used;
        frame.kernel.range(this->batch(padded(used), frame.scene.uniforms.template boxes<Real>()));
    }
};

/// Puts the box of [from, to] of a packet into slot `slot` of the batch. Products are added, see
/// k_rays-inl.hpp.
template <class Real>
HWY_INLINE void store_box(const Packet<Real>& packet, V<Real> from, V<Real> to, std::size_t slot,
                          Batch<Real>& batch) {
    Real* const at = batch.ends[0] + slot * lanes<Real>;
    const Axes<Real>& axes = *packet.axes;
    const V<Real> neg_from = hn::Neg(from);
    hn::Store(neg_from, d<Real>, at + axes.from_offset[0]);
    hn::Store(to, d<Real>, at + axes.to_offset[0]);
    for (int i = 1; i < 3; ++i) {
        const AxisLines<Real>& line = packet.line[i - 1];
        const V<Real> slope_lo = hn::Load(d<Real>, line.slope_lo);
        const V<Real> neg_at = hn::Load(d<Real>, line.neg_lo);
        const V<Real> neg_lo = hn::MulAdd(slope_lo, neg_from, neg_at);
        const auto put = [&](V<Real> neg_least, V<Real> slope_hi) {
            hn::Store(neg_least, d<Real>, at + axes.from_offset[i]);
            hn::Store(hn::MulAdd(slope_hi, to, hn::Load(d<Real>, line.hi)), d<Real>,
                      at + axes.to_offset[i]);
        };
        if constexpr (sizeof(Real) == sizeof(double)) {
            put(hn::Max(neg_lo, hn::MulAdd(slope_lo, hn::Neg(to), neg_at)),
                hn::Load(d<Real>, line.slope_hi));
        } else {
            put(neg_lo, slope_lo);
        }
    }
}

template <class Real>
HWY_INLINE M<Real> is_continuous(const Batch<Real>& batch, std::size_t slot) {
    const auto bits = hn::Load(du<Real>, batch.continuous + slot * lanes<Real>);
    return hn::RebindMask(d<Real>, hn::Ne(bits, hn::Zero(du<Real>)));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
