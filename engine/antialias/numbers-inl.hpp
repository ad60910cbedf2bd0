// Numbers of some lanes only, and flags as columns of numbers.
// Included once for each instruction set, after Highway.

#if defined(ZEROSET_NUMBERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_NUMBERS_INL
#undef ZEROSET_NUMBERS_INL
#else
#define ZEROSET_NUMBERS_INL
#endif

#include "engine/real/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

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
