#pragma once

// Which instruction sets are used: those that the processor has, up to what ZEROSET_WIDEST in the
// environment says, the bytes of the widest registers: 64 (AVX-512), 32 (AVX2 and FMA) or 16
// (SSE4). It is read once; with it one machine tests, and times, what others run. Any thread.

namespace zeroset {

/// Bytes of the widest registers that may be used, whatever the processor has.
int widest_registers_allowed();

bool machine_has_fma();
bool machine_has_avx2_fma();
bool machine_has_avx512();

}  // namespace zeroset
