#pragma once

#include "engine/real/sleef.hpp"

// Private to engine/num: one translation unit per instruction set defines these for float and
// double.

namespace zeroset {

inline bool machine_has_avx2_fma() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
inline bool machine_has_avx512() {
    return machine_has_avx2_fma() && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

template <class Real>
const void* sleef_plain(Elementary function);
template <class Real>
const void* sleef_fma(Elementary function);
template <class Real>
const void* sleef_sse2(Elementary function);
template <class Real>
const void* sleef_avx2_128(Elementary function);
template <class Real>
const void* sleef_avx2_256(Elementary function);
template <class Real>
const void* sleef_avx512(Elementary function);

}  // namespace zeroset
