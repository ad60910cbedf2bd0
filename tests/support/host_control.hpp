#pragma once

#include <immintrin.h>

#include <cfenv>

namespace zeroset::test {

inline constexpr int all_modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
/// The ways in which a host may treat denormals.
inline constexpr unsigned all_flushes[] = {0U, _MM_FLUSH_ZERO_ON, _MM_DENORMALS_ZERO_ON,
                                           _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON};
inline constexpr unsigned flush_all = all_flushes[3];

/// The control word of the vector registers, without the flags that past operations left in it.
inline unsigned control() {
    constexpr unsigned sticky_flags = 0x3F;
    return _mm_getcsr() & ~sticky_flags;
}

/// Sets a host's rounding mode and treatment of denormals on this thread while it lives; then
/// restores the latter and sets round-to-nearest.
class HostControl {
public:
    HostControl(int mode, unsigned flush) {
        std::fesetround(mode);
        _mm_setcsr(_mm_getcsr() | flush);
    }
    ~HostControl() {
        std::fesetround(FE_TONEAREST);
        _mm_setcsr(before_);
    }
    HostControl(const HostControl&) = delete;
    HostControl& operator=(const HostControl&) = delete;

private:
    unsigned before_ = _mm_getcsr();
};

}  // namespace zeroset::test
