#pragma once

#include <cfenv>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// The only file that touches the processor's rounding mode. Intervals are stored as (-lo, hi), so
// that under upward rounding both ends round outward.

namespace zeroset {

/// Rounds in `Mode` (FE_UPWARD, FE_TONEAREST, FE_DOWNWARD) while it lives, on this thread. Keeps
/// the compiler from moving floating-point work across its two ends only if that work happens in
/// a function that is not inlined here: guard whole batches.
template <int Mode>
class RoundingGuard {
public:
    RoundingGuard() : saved_(std::fegetround()) { std::fesetround(Mode); }
    ~RoundingGuard() { std::fesetround(saved_); }
    RoundingGuard(const RoundingGuard&) = delete;
    RoundingGuard& operator=(const RoundingGuard&) = delete;

private:
    int saved_;
};

using UpwardRounding = RoundingGuard<FE_UPWARD>;
using NearestRounding = RoundingGuard<FE_TONEAREST>;
using DownwardRounding = RoundingGuard<FE_DOWNWARD>;

#if defined(__SSE2__)
/// Round to nearest around one call into a library of elementary functions, for SSE and AVX code
/// only: a pair of switches costs about a nanosecond. Denormals stay, exceptions stay masked.
class NearestCall {
public:
    NearestCall() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ & ~0x6000U); }
    ~NearestCall() { _mm_setcsr(saved_); }
    NearestCall(const NearestCall&) = delete;
    NearestCall& operator=(const NearestCall&) = delete;

private:
    unsigned saved_;
};
#else
using NearestCall = NearestRounding;
#endif

}  // namespace zeroset
