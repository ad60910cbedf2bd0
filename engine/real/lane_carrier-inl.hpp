// Highway's vectors as a carrier (scalar.hpp): the operations that arithmetic over any carrier asks
// of them, a lane at a time. Included once for each instruction set, after Highway.

#if defined(ZEROSET_LANE_CARRIER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_LANE_CARRIER_INL
#undef ZEROSET_LANE_CARRIER_INL
#else
#define ZEROSET_LANE_CARRIER_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/real/scalar.hpp"

#include <hwy/highway.h>

#include <concepts>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

using zeroset::both;
using zeroset::either;
using zeroset::fused;
using zeroset::like;
using zeroset::magnitude;
using zeroset::maximum;
using zeroset::minimum;

/// A vector of Highway or a mask of one.
template <class Lanes>
concept IsLanes = !std::is_arithmetic_v<Lanes>;

template <IsLanes Lanes>
HWY_INLINE Lanes like(Lanes /*kind*/, double value) {
    return hn::Set(hn::DFromV<Lanes>(), static_cast<hn::TFromV<Lanes>>(value));
}
/// The second argument where both are equal or unordered, as of numbers.
template <IsLanes Lanes>
HWY_INLINE Lanes maximum(Lanes a, Lanes b) {
    return hn::Max(a, b);
}
template <IsLanes Lanes>
HWY_INLINE Lanes minimum(Lanes a, Lanes b) {
    return hn::Min(a, b);
}
template <IsLanes Lanes>
HWY_INLINE Lanes magnitude(Lanes a) {
    return hn::Abs(a);
}
template <IsLanes Lanes>
HWY_INLINE Lanes fused(Lanes a, Lanes b, Lanes c) {
    return hn::MulAdd(a, b, c);
}
template <IsLanes Mask>
HWY_INLINE Mask both(Mask a, Mask b) {
    return hn::And(a, b);
}
template <IsLanes Mask>
HWY_INLINE Mask either(Mask a, Mask b) {
    return hn::Or(a, b);
}

/// c - a b, rounded once or twice.
template <std::floating_point Real>
HWY_INLINE Real less_product(Real a, Real b, Real c) {
    return c - a * b;
}
template <IsLanes Lanes>
HWY_INLINE Lanes less_product(Lanes a, Lanes b, Lanes c) {
    return hn::NegMulAdd(a, b, c);
}
template <std::floating_point Real>
HWY_INLINE Real negative(Real a) {
    return -a;
}
template <IsLanes Lanes>
HWY_INLINE Lanes negative(Lanes a) {
    return hn::Neg(a);
}

/// The type of a carrier's numbers.
template <class Real>
struct NumberOf {
    using Type = hn::TFromV<Real>;
};
template <std::floating_point Real>
struct NumberOf<Real> {
    using Type = Real;
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
