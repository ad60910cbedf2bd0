// Vectors of doubles for functions that go through arrays of lanes, a vector at a time.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_DOUBLE_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_DOUBLE_VECTORS_INL
#undef ZEROSET_DOUBLE_VECTORS_INL
#else
#define ZEROSET_DOUBLE_VECTORS_INL
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D d;
constexpr std::size_t width = hn::MaxLanes(D());

HWY_INLINE V number(double x) { return hn::Set(d, x); }
HWY_INLINE V minimum(V a, V b) { return hn::IfThenElse(hn::Lt(a, b), a, b); }
HWY_INLINE V maximum(V a, V b) { return hn::IfThenElse(hn::Gt(a, b), a, b); }

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
