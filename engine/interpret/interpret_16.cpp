#include "engine/interpret/interpret-inl.hpp"

namespace zeroset {

const InterpreterCode& interpreter_code_16() {
    static constexpr InterpreterCode code = interpreter_code_of<16>();
    return code;
}

}  // namespace zeroset
