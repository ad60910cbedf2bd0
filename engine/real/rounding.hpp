#pragma once

#include <immintrin.h>

#include <cfenv>

// The only file that touches the processor's rounding mode. Intervals are stored as (-lo, hi), so
// that under upward rounding both ends round outward.
//
// Arithmetic obeys the control word of the vector registers (MXCSR); the C library's fegetround
// tells the mode of the other word, x87's, and fesetround sets both. The guards keep the two
// together and set the whole of MXCSR: where the host flushes denormals to zero, an upper bound of
// 2^-140 would become 0, which bounds nothing.

namespace zeroset {

namespace detail {

/// No exception traps, denormals as they are, to nearest.
inline constexpr unsigned default_control = 0x1F80;
/// What of MXCSR changes results: the rounding mode and how denormals are taken.
inline constexpr unsigned control_of_results =
    _MM_ROUND_MASK | _MM_FLUSH_ZERO_MASK | _MM_DENORMALS_ZERO_MASK;

/// MXCSR for a mode of <cfenv>, whose bits are those of the x87 word.
constexpr unsigned control_word(int mode) {
    static_assert(FE_UPWARD << 3U == _MM_ROUND_UP && FE_DOWNWARD << 3U == _MM_ROUND_DOWN);
    return default_control | static_cast<unsigned>(mode) << 3U;
}

}  // namespace detail

/// Rounds in `Mode` (FE_UPWARD, FE_TONEAREST, FE_DOWNWARD) while it lives, on this thread, with
/// denormals as they are; then all is as it was before. Keeps the compiler from moving
/// floating-point work across its two ends only if that work happens in a function that is not
/// inlined here: guard whole batches.
template <int Mode>
class RoundingGuard {
public:
    RoundingGuard() {
        std::fesetround(Mode);
        _mm_setcsr(detail::control_word(Mode));
    }
    ~RoundingGuard() {
        std::fesetround(mode_);
        _mm_setcsr(control_);
    }
    RoundingGuard(const RoundingGuard&) = delete;
    RoundingGuard& operator=(const RoundingGuard&) = delete;

private:
    int mode_ = std::fegetround();
    unsigned control_ = _mm_getcsr();
};

/// Rounds upward while it lives, in the vector registers only: fegetround still tells the mode of
/// the caller. For small tasks that only compute: a guard's two calls take as long as some pixels.
class UpwardRegisters {
public:
    UpwardRegisters() { _mm_setcsr(detail::control_word(FE_UPWARD)); }
    ~UpwardRegisters() { _mm_setcsr(control_); }
    UpwardRegisters(const UpwardRegisters&) = delete;
    UpwardRegisters& operator=(const UpwardRegisters&) = delete;

private:
    unsigned control_ = _mm_getcsr();
};

using UpwardRounding = RoundingGuard<FE_UPWARD>;
using NearestRounding = RoundingGuard<FE_TONEAREST>;
using DownwardRounding = RoundingGuard<FE_DOWNWARD>;

/// Whether this thread computes as under UpwardRounding.
inline bool rounds_upward() { return (_mm_getcsr() & detail::control_of_results) == _MM_ROUND_UP; }

/// Round to nearest around one call out of code that runs in upward rounding, to which it returns
/// whatever the mode was before. Reading the mode first would cost more than both switches: 11 ns
/// a pair against 2.
class NearestCall {
public:
    NearestCall() { _mm_setcsr(detail::control_word(FE_TONEAREST)); }
    ~NearestCall() { _mm_setcsr(detail::control_word(FE_UPWARD)); }
    NearestCall(const NearestCall&) = delete;
    NearestCall& operator=(const NearestCall&) = delete;
};

}  // namespace zeroset
