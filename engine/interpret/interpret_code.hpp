#pragma once

#include "engine/kernel/kernel.hpp"

#include <cstddef>

// The interpreter's functions for each kind of registers. Private to the interpreter.

namespace zeroset {

class Tape;

/// The functions of Kernel as the interpreter has them; `code` is a Tape.
struct InterpreterCode {
    template <class Batch>
    using Function = void (*)(const void* code, const Batch* batch);
    /// Records the choices of a whole batch; `record` has room for it.
    template <class Real>
    using Record = void (*)(const Tape& tape, const FormBatchOf<Real>& batch, ChoiceRecord& record);

    /// The functions in one type, of the names of KernelsOf.
    template <class Real>
    struct In {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a declared name, and a template
#define ZEROSET_KERNEL_FUNCTION(name, kind, Batch) Function<Batch<Real>> name;
#include "engine/kernel/kernel_functions.def"
        Record<Real> record;
    };

    In<float> in_float;
    In<double> in_double;
    Function<RayValueBatch> ray_value;
    Function<ValueBatchOf<double>> points;  ///< values without gradients
};

/// This thread's memory for the values of a graph, kept from call to call. The code of a part may
/// be an interpreter, too, inside that of the whole: it has room of its own.
class Scratch {
public:
    static constexpr std::size_t alignment = 64;

    explicit Scratch(std::size_t bytes);
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch();

    [[nodiscard]] void* data() const { return data_; }

private:
    void* data_;
};

/// The widest that this machine has.
const InterpreterCode& interpreter_code();

/// For registers of 16 bytes, 32 (AVX2 and FMA) and 64 (AVX-512).
const InterpreterCode& interpreter_code_16();
const InterpreterCode& interpreter_code_32();
const InterpreterCode& interpreter_code_64();

}  // namespace zeroset
