#pragma once

#include "engine/real/sleef.hpp"

// Private to engine/real: tables of SLEEF's functions for float and double, each defined by the one
// translation unit of its instruction set.

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
