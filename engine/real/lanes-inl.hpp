// The words in which loops over vectors of numbers speak to Highway, everywhere: vectors, masks,
// lanes, numbers in all lanes, masks as bits.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_LANES_INL
#undef ZEROSET_LANES_INL
#else
#define ZEROSET_LANES_INL
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

/// A number in all lanes.
template <class Real>
HWY_INLINE V<Real> number(double value) {
    return hn::Set(d<Real>, static_cast<Real>(value));
}
HWY_INLINE V<double> number(double value) { return hn::Set(d<double>, value); }

/// Numbers from and to columns of them.
HWY_INLINE V<float> load(const float* from) { return hn::LoadU(d<float>, from); }
HWY_INLINE V<double> load(const double* from) { return hn::LoadU(d<double>, from); }
HWY_INLINE void store(V<float> numbers, float* to) { hn::StoreU(numbers, d<float>, to); }
HWY_INLINE void store(V<double> numbers, double* to) { hn::StoreU(numbers, d<double>, to); }

/// Numbers of either type as doubles.
template <class D>
HWY_INLINE hn::Vec<D> load_doubles(D tag, const float* from) {
    return hn::PromoteTo(tag, hn::LoadU(hn::Rebind<float, D>(), from));
}
template <class D>
HWY_INLINE hn::Vec<D> load_doubles(D tag, const double* from) {
    return hn::LoadU(tag, from);
}

/// A bit for each lane of a vector, the first one lowest.
using LaneBits = std::uint32_t;

template <class D>
constexpr LaneBits all_lanes = (LaneBits{1} << hn::MaxLanes(D())) - 1;

template <class D>
HWY_INLINE LaneBits bits_of(D tag, hn::Mask<D> mask) {
#if HWY_TARGET <= HWY_AVX3
    static_cast<void>(tag);
    return mask.raw & all_lanes<D>;
#else
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(tag, mask, bytes);
    return bytes[0] | static_cast<LaneBits>(bytes[1]) << 8U;
#endif
}
/// The lanes whose bits are set; bits beyond the lanes do not matter.
template <class D>
HWY_INLINE hn::Mask<D> mask_of(D tag, LaneBits bits) {
#if HWY_TARGET <= HWY_AVX3
    static_cast<void>(tag);
    return {static_cast<decltype(hn::Mask<D>::raw)>(bits & all_lanes<D>)};
#else
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                   static_cast<std::uint8_t>(bits >> 8U)};
    return hn::LoadMaskBits(tag, bytes);
#endif
}
/// The lanes whose words, as wide as the numbers, are all ones; other words are 0.
template <class D, class Word>
HWY_INLINE hn::Mask<D> mask_at(D tag, const Word* words) {
    return hn::MaskFromVec(hn::BitCast(tag, hn::LoadU(hn::RebindToUnsigned<D>(), words)));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
