#pragma once

#include "engine/kernel/batches.hpp"
#include "engine/kernel/kernel_memory.hpp"
#include "engine/kernel/specializer.hpp"
#include "engine/kernel/uniforms.hpp"
#include "engine/real/rounding.hpp"

#include <cassert>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace zeroset {

class FloatCheck;
struct SurfaceFacts;

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

/// The functions of a kernel in one type; engine/kernel/kernel_functions.def says what each does.
template <class Real>
struct KernelsOf {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a declared name, and a template
#define ZEROSET_KERNEL_FUNCTION(name, kind, Batch) KernelFunction<Batch<Real>> name;
#include "engine/kernel/kernel_functions.def"
};

/// The code of one formula, by whomever it was made (jit/compile or engine/interpret): all that a
/// tracer knows of f.
struct Kernel {
    KernelsOf<float> in_float;
    KernelsOf<double> in_double;  ///< slow but for `value`, unless `has_double`
    KernelFunction<RayValueBatch> ray_value;
    /// Divides batch_multiple; sizes of FormBatchOf, NewtonBatchOf and RayValueBatch are multiples.
    std::size_t lane_multiple = batch_multiple;
    bool has_double = false;              ///< whole frames can be traced in double
    std::vector<std::string> parameters;  ///< names of the uniforms after w
    bool uses_w = false;
    std::size_t switches = 0;  ///< number of switches in HeldSwitches
    bool branches = false;     ///< BranchBits may be other than 0; else they are not written
    std::shared_ptr<const Specializer> specializer;  ///< nullptr where it would not pay
    bool interpreted = false;                        ///< else machine code
    std::size_t steps = 0;  ///< steps of the interpreter for an item; 0: machine code
    std::shared_ptr<const FloatCheck> float_check;  ///< nullptr: floats suffice
    std::shared_ptr<const SurfaceFacts> facts;      ///< of f; nullptr: none are known
    /// Things that tracers keep of this function from frame to frame; not nullptr.
    std::shared_ptr<KernelMemory> memory = std::make_shared<KernelMemory>();

    /// The functions in one type.
    template <class Real>
    [[nodiscard]] const KernelsOf<Real>& in() const {
        if constexpr (std::is_same_v<Real, float>) {
            return in_float;
        } else {
            return in_double;
        }
    }

    // The function of each name, in the batch's type.
#define ZEROSET_KERNEL_FUNCTION(name, kind, Batch) \
    template <class Real>                          \
    void name(const Batch<Real>& batch) const {    \
        in<Real>().name(batch);                    \
    }
#include "engine/kernel/kernel_functions.def"

    explicit operator bool() const { return static_cast<bool>(in_float.range); }

    /// A kernel whose functions never wait for their code to be made.
    [[nodiscard]] Kernel without_waiting() const;
};

/// Calls `visit` with each function of a kernel; with several kernels, or tables with members of
/// the same names, once for each name with the functions of all of them.
template <class Visit, class... Kernels>
void visit_functions(Visit&& visit, Kernels&&... kernels) {
#define ZEROSET_KERNEL_FUNCTION(name, kind, Batch) \
    visit(kernels.in_float.name...);               \
    visit(kernels.in_double.name...);
#include "engine/kernel/kernel_functions.def"
    visit(kernels.ray_value...);
}

inline Kernel Kernel::without_waiting() const {
    Kernel kernel = *this;
    visit_functions([](auto& function) { function = function.without_waiting(); }, kernel);
    return kernel;
}

}  // namespace zeroset
