// The interpreter in registers of 64 bytes. What the standard library defines stays code for every
// machine; what follows is for those that have these registers.

// GCC 12 takes the registers that its own intrinsics leave undefined for a mistake.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"

#include "engine/interpret/interpret_std.hpp"

#define ZEROSET_BLOCK_BYTES 64
#pragma GCC target("avx2,fma,avx512f,avx512dq,avx512vl")

#include "engine/interpret/interpret-inl.hpp"

namespace zeroset {

const InterpreterCode& interpreter_code_64() {
    static constexpr InterpreterCode code = interpreter_code_of<64>();
    return code;
}

}  // namespace zeroset
