#pragma once

#include "engine/kernel/kernel.hpp"

#include <cstddef>

// The interpreter's functions for each kind of registers. Private to the interpreter.

namespace zeroset {

class Tape;

/// As the functions of Kernel; `code` is a Tape.
struct InterpreterCode {
    template <class Batch>
    using Function = void (*)(const void* code, const Batch* batch);
    /// Of a whole batch; `record` has room for it.
    template <class Real>
    using Record = void (*)(const Tape& tape, const FormBatchOf<Real>& batch, ChoiceRecord& record);

    Function<RangeBatchOf<float>> range_float;
    Function<ValueBatchOf<float>> value_float;
    Function<FormBatchOf<float>> form_float;
    Function<FormBatchOf<float>> ray_form_float;
    Function<NewtonBatchOf<float>> newton_float;
    Record<float> record_float;
    Function<RangeBatchOf<double>> range_double;
    Function<ValueBatchOf<double>> value_double;
    Function<FormBatchOf<double>> form_double;
    Function<FormBatchOf<double>> ray_form_double;
    Function<NewtonBatchOf<double>> newton_double;
    Record<double> record_double;
    Function<RayValueBatch> ray_value;
    Function<ValueBatchOf<double>> point_double;  ///< without gradients
};

/// This thread's room for the values of a graph, kept from call to call. The code of a part may be
/// an interpreter, too, inside that of the whole: it has room of its own.
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
