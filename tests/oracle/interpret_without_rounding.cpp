// A mutant of the interpreter, whose forms leave out the rounding errors of their coefficients.
// Linked in place of the engine's own choice of code; the checks of forms must find it wrong.

#include "engine/num/beam.hpp"
#include "engine/real/block.hpp"

namespace zeroset {

template <>
Block<float> form_rounding(const Block<float>& /*kind*/) {
    return Block<float>::splat(0);
}
template <>
Block<double> form_rounding(const Block<double>& /*kind*/) {
    return Block<double>::splat(0);
}

}  // namespace zeroset

#include "engine/interpret/interpret-inl.hpp"

namespace zeroset {

const InterpreterCode& interpreter_code() {
    static constexpr InterpreterCode code = interpreter_code_of<16>();
    return code;
}

}  // namespace zeroset
