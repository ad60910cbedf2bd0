#pragma once

#include "engine/num/sleef.hpp"

// Private to engine/num: one translation unit per instruction set defines these.

namespace zeroset {

inline bool machine_has_avx2_fma() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
inline bool machine_has_avx512() {
    return machine_has_avx2_fma() && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

const void* sleef_plain_1(Elementary function);
const void* sleef_fma_1(Elementary function);
const void* sleef_sse2_4(Elementary function);
const void* sleef_avx2_4(Elementary function);
const void* sleef_avx2_8(Elementary function);
const void* sleef_avx512_16(Elementary function);

}  // namespace zeroset
