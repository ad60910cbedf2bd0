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

/// Round to nearest around one call out of code that runs in upward rounding, to which it returns
/// whatever the mode was before. Reading the mode first would cost more than both switches: 11 ns
/// a pair against 2.
#if defined(__SSE2__)
class NearestCall {
public:
    NearestCall() { _mm_setcsr(all_masked); }
    ~NearestCall() { _mm_setcsr(all_masked | _MM_ROUND_UP); }
    NearestCall(const NearestCall&) = delete;
    NearestCall& operator=(const NearestCall&) = delete;

private:
    static constexpr unsigned all_masked = 0x1F80;  // no exception traps, denormals as they are
};
#else
class NearestCall {
public:
    NearestCall() { std::fesetround(FE_TONEAREST); }
    ~NearestCall() { std::fesetround(FE_UPWARD); }
    NearestCall(const NearestCall&) = delete;
    NearestCall& operator=(const NearestCall&) = delete;
};
#endif

}  // namespace zeroset
