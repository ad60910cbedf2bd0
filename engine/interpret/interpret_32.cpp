// The interpreter in registers of 32 bytes. What the standard library defines stays code for every
// machine; what follows is for those that have these registers.

#include "engine/interpret/interpret_std.hpp"

#define ZEROSET_BLOCK_BYTES 32
#pragma GCC target("avx2,fma")

#include "engine/interpret/interpret-inl.hpp"

namespace zeroset {

const InterpreterCode& interpreter_code_32() {
    static constexpr InterpreterCode code = interpreter_code_of<32>();
    return code;
}

}  // namespace zeroset
