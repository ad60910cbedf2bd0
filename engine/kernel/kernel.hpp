#pragma once

#include "engine/kernel/batches.hpp"
#include "engine/kernel/specializer.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/real/rounding.hpp"

#include <cassert>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace zeroset {

class FloatCheck;

/// Code over batches of one kind, with what keeps it alive. Cheap to copy; safe to call from any
/// number of threads, in upward rounding (engine/real/rounding.hpp), or the enclosures do not hold.
template <class Batch>
struct KernelFunction {
    void (*call)(const void* code, const Batch* batch) = nullptr;
    std::shared_ptr<const void> code;
    /// Does what `call` does, without waiting for code that that one makes first: by slower code.
    /// nullptr: `call` never waits.
    void (*meanwhile)(const void* code, const Batch* batch) = nullptr;

    void operator()(const Batch& batch) const {
        assert(rounds_upward());
        call(code.get(), &batch);
    }
    /// The function that never waits: `meanwhile` where there is one, else this.
    [[nodiscard]] KernelFunction without_waiting() const {
        return {meanwhile != nullptr ? meanwhile : call, code};
    }
    explicit operator bool() const { return call != nullptr; }
    bool operator==(const KernelFunction&) const = default;
};

/// f in double at points; the batch's `gradient` is left alone.
using PointFunction = KernelFunction<ValueBatchOf<double>>;

/// What the tracer asks of a formula, whoever made the code (jit/compile or
/// engine/expr/interpret).
struct Kernel {
    KernelFunction<RangeBatchOf<float>> range_float;
    KernelFunction<ValueBatchOf<float>> value_float;
    KernelFunction<FormBatchOf<float>> form_float;
    KernelFunction<FormBatchOf<float>> ray_form_float;  ///< of cells without width
    KernelFunction<NewtonBatchOf<float>> newton_float;
    KernelFunction<RayValueBatch> ray_value;
    // Slow (interpreted) but for the values, unless whole frames can be traced in double.
    KernelFunction<RangeBatchOf<double>> range_double;
    KernelFunction<ValueBatchOf<double>> value_double;
    KernelFunction<FormBatchOf<double>> form_double;
    KernelFunction<FormBatchOf<double>> ray_form_double;
    KernelFunction<NewtonBatchOf<double>> newton_double;
    /// Of the sizes of FormBatchOf, NewtonBatchOf and RayValueBatch; divides batch_multiple.
    std::size_t lane_multiple = batch_multiple;
    bool has_double = false;              ///< whether whole frames can be traced in double
    std::vector<std::string> parameters;  ///< names of the uniforms after w
    bool uses_w = false;
    std::size_t switches = 0;  ///< of HeldSwitches
    bool branches = false;     ///< whether BranchBits are ever but 0; else they are not written
    std::shared_ptr<const Specializer> specializer;  ///< nullptr where it would not pay
    bool interpreted = false;                        ///< else machine code
    std::size_t steps = 0;  ///< that the interpreter takes for an item; 0: machine code
    std::shared_ptr<const FloatCheck> float_check;  ///< nullptr: floats suffice
    /// Ranges of functions whose zeros are zeros of f (engine/rewrite/root_witnesses.hpp).
    std::vector<KernelFunction<RangeBatchOf<double>>> witnesses;
    bool defined_everywhere = false;  ///< for all values of the variables, surely
    /// Ranges of a function that is continuous only where f is defined; none: not known.
    KernelFunction<RangeBatchOf<double>> domain;

    void range(const RangeBatchOf<float>& batch) const { range_float(batch); }
    void range(const RangeBatchOf<double>& batch) const { range_double(batch); }
    void value(const ValueBatchOf<float>& batch) const { value_float(batch); }
    void value(const ValueBatchOf<double>& batch) const { value_double(batch); }
    void form(const FormBatchOf<float>& batch) const { form_float(batch); }
    void form(const FormBatchOf<double>& batch) const { form_double(batch); }
    /// As `form`; the frustum's radii are 0.
    void ray_form(const FormBatchOf<float>& batch) const { ray_form_float(batch); }
    void ray_form(const FormBatchOf<double>& batch) const { ray_form_double(batch); }
    void newton(const NewtonBatchOf<float>& batch) const { newton_float(batch); }
    void newton(const NewtonBatchOf<double>& batch) const { newton_double(batch); }
    explicit operator bool() const { return static_cast<bool>(range_float); }

    /// A kernel whose functions never wait for their code to be made.
    [[nodiscard]] Kernel without_waiting() const {
        Kernel kernel = *this;
        const auto change = [](auto&... functions) {
            ((functions = functions.without_waiting()), ...);
        };
        change(kernel.range_float, kernel.value_float, kernel.form_float, kernel.ray_form_float,
               kernel.newton_float, kernel.ray_value, kernel.range_double, kernel.value_double,
               kernel.form_double, kernel.ray_form_double, kernel.newton_double);
        return kernel;
    }
};

}  // namespace zeroset
