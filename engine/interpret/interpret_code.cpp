#include "engine/interpret/interpret_code.hpp"

#include "engine/real/processor.hpp"

namespace zeroset {

const InterpreterCode& interpreter_code() {
    static const InterpreterCode& widest = machine_has_avx512()     ? interpreter_code_64()
                                           : machine_has_avx2_fma() ? interpreter_code_32()
                                                                    : interpreter_code_16();
    return widest;
}

}  // namespace zeroset
