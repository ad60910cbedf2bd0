#pragma once

#include "engine/real/sleef.hpp"

// Private to engine/real: tables of SLEEF's functions for float and double, each defined by the one
// translation unit of its instruction set.

namespace zeroset {

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
