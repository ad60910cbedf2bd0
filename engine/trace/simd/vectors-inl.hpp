// The words of vectors that all loops over rays and cells share: tags, lanes, masks as bits.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_VECTORS_INL
#undef ZEROSET_VECTORS_INL
#else
#define ZEROSET_VECTORS_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The widest vectors of the machine, up to 64 bytes; of Real, their vectors and masks.
template <class Real>
using Tag = hn::CappedTag<Real, 64 / sizeof(Real)>;
template <class Real>
using V = hn::Vec<Tag<Real>>;
template <class Real>
using M = hn::Mask<Tag<Real>>;
template <class Real>
constexpr Tag<Real> d{};
/// Unsigned words as wide as the numbers.
template <class Real>
constexpr hn::RebindToUnsigned<Tag<Real>> du{};

template <class Real>
constexpr std::size_t lanes = hn::MaxLanes(Tag<Real>());
template <class Real>
constexpr std::size_t vector_bytes = lanes<Real> * sizeof(Real);

/// A bit for each lane of a vector, the first one lowest.
using LaneBits = std::uint32_t;

template <class D>
HWY_INLINE LaneBits bits_of(D tag, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(tag, mask, bytes);
    return bytes[0] | static_cast<LaneBits>(bytes[1]) << 8U;
}

/// The lanes whose bits are set.
template <class D>
HWY_INLINE hn::Mask<D> mask_of(D tag, LaneBits bits) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                   static_cast<std::uint8_t>(bits >> 8U)};
    return hn::LoadMaskBits(tag, bytes);
}

/// The lanes whose words, as wide as the numbers, are all ones; other words are 0.
template <class D, class Word>
HWY_INLINE hn::Mask<D> mask_at(D tag, const Word* words) {
    return hn::MaskFromVec(hn::BitCast(tag, hn::LoadU(hn::RebindToUnsigned<D>(), words)));
}

/// Numbers of either type as doubles.
template <class D>
HWY_INLINE hn::Vec<D> load_doubles(D tag, const float* from) {
    return hn::PromoteTo(tag, hn::LoadU(hn::Rebind<float, D>(), from));
}
template <class D>
HWY_INLINE hn::Vec<D> load_doubles(D tag, const double* from) {
    return hn::LoadU(tag, from);
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
