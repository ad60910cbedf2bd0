#pragma once

#include <immintrin.h>

#include <cfenv>

// The only file that touches the processor's rounding mode. Intervals are stored as (-lo, hi), so
// that under upward rounding both ends round outward.
//
// Arithmetic obeys the control word of the vector registers (MXCSR). The C library's fegetround
// returns the mode of the x87 control word; fesetround sets both. The guards keep the two equal and
// set all of MXCSR: where the host flushes denormals to zero, an upper bound of 2^-140 would become
// 0, which bounds nothing.

namespace zeroset {

namespace detail {

/// MXCSR with no exception traps, with denormals, in round-to-nearest.
inline constexpr unsigned default_control = 0x1F80;
/// The bits of MXCSR that change results: the rounding mode and the treatment of denormals.
inline constexpr unsigned control_of_results =
    _MM_ROUND_MASK | _MM_FLUSH_ZERO_MASK | _MM_DENORMALS_ZERO_MASK;

/// MXCSR for a rounding mode of <cfenv>, whose values are bits of the x87 control word.
constexpr unsigned control_word(int mode) {
    static_assert(FE_UPWARD << 3U == _MM_ROUND_UP && FE_DOWNWARD << 3U == _MM_ROUND_DOWN);
    return default_control | static_cast<unsigned>(mode) << 3U;
}

}  // namespace detail

/// Sets the rounding mode `mode` (FE_UPWARD, FE_TONEAREST, FE_DOWNWARD) on this thread while it
/// lives, with denormals; then restores what was set before. Keeps the compiler from moving
/// floating-point work across its two ends only if that work happens in a function that is not
/// inlined here: guard whole batches.
template <int mode>
class RoundingGuard {
public:
    RoundingGuard() {
        std::fesetround(mode);
        _mm_setcsr(detail::control_word(mode));
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

/// Makes `long double` round to nearest while it lives. It obeys the x87 control word alone, which
/// kernels' callers set or leave; its results shall not depend on that.
class NearestLongDouble {
public:
    NearestLongDouble() {
        asm volatile("fnstcw %0" : "=m"(control_));
        constexpr unsigned rounding_bits = 0x0C00;
        const auto nearest = static_cast<unsigned short>(control_ & ~rounding_bits);
        asm volatile("fldcw %0" : : "m"(nearest));
    }
    ~NearestLongDouble() { asm volatile("fldcw %0" : : "m"(control_)); }
    NearestLongDouble(const NearestLongDouble&) = delete;
    NearestLongDouble& operator=(const NearestLongDouble&) = delete;

private:
    unsigned short control_ = 0;
};

/// Sets upward rounding while it lives, in the vector registers only: fegetround still returns the
/// caller's mode. For small tasks that only compute, as the two calls of a guard take as long as
/// some pixels.
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

/// Whether this thread rounds as under UpwardRounding.
inline bool rounds_upward() { return (_mm_getcsr() & detail::control_of_results) == _MM_ROUND_UP; }

/// Sets round-to-nearest for one call out of code that runs in upward rounding; afterwards sets
/// upward rounding, whatever the mode was before. Reading that mode first would cost more than both
/// switches: 11 ns a pair instead of 2.
class NearestCall {
public:
    NearestCall() { _mm_setcsr(detail::control_word(FE_TONEAREST)); }
    ~NearestCall() { _mm_setcsr(detail::control_word(FE_UPWARD)); }
    NearestCall(const NearestCall&) = delete;
    NearestCall& operator=(const NearestCall&) = delete;
};

}  // namespace zeroset
