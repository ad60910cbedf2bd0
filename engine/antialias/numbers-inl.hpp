// Vectors of numbers, from and to columns of them.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_NUMBERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_NUMBERS_INL
#undef ZEROSET_NUMBERS_INL
#else
#define ZEROSET_NUMBERS_INL
#endif

#include "engine/trace/simd/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

HWY_INLINE V<double> number(double value) { return hn::Set(d<double>, value); }
template <class Real>
HWY_INLINE V<Real> number(double value) {
    return hn::Set(d<Real>, static_cast<Real>(value));
}
HWY_INLINE V<float> load(const float* from) { return hn::LoadU(d<float>, from); }
HWY_INLINE V<double> load(const double* from) { return hn::LoadU(d<double>, from); }
HWY_INLINE void store(V<float> numbers, float* to) { hn::StoreU(numbers, d<float>, to); }
HWY_INLINE void store(V<double> numbers, double* to) { hn::StoreU(numbers, d<double>, to); }
/// Stores numbers in some lanes.
HWY_INLINE void store_in(M<double> lanes, V<double> numbers, double* to) {
    store(hn::IfThenElse(lanes, numbers, load(to)), to);
}
/// Flags as numbers, 1 and 0.
HWY_INLINE V<double> flags(M<double> lanes) { return hn::IfThenElseZero(lanes, number(1.0)); }
HWY_INLINE M<double> flags_at(const double* from) {
    return hn::Ne(load(from), hn::Zero(d<double>));
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
