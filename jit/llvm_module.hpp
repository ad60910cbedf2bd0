#pragma once

#include "engine/expr/expr.hpp"
#include "engine/real/format.hpp"
#include "jit/compile.hpp"

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

// The functions that the program calls in its module zeroset_llvm.so, the room jit/llvm with LLVM
// behind it, which is loaded when code is first made: LLVM takes as long to load as many a picture
// takes to be drawn.

namespace zeroset::jit {

/// Kind of the vectors that code works on.
struct VectorKind {
    RealType type;
    int lanes;
};

/// The kinds of functions that code is made for.
enum class KernelKind : std::uint8_t {
#define ZEROSET_KERNEL_FUNCTION(name, kind, Batch) kind,
#include "engine/kernel/kernel_functions.def"
    RayValue,
    Points,  ///< values without gradients, for a PointFunction
};

/// The kinds that are functions of a Kernel.
inline constexpr KernelKind kernel_kinds[] = {
#define ZEROSET_KERNEL_FUNCTION(name, kind, Batch) KernelKind::kind,
#include "engine/kernel/kernel_functions.def"
    KernelKind::RayValue};

/// The name of a kind's function in machine code.
constexpr const char* symbol_of(KernelKind kind) {
    switch (kind) {
#define ZEROSET_KERNEL_FUNCTION(name, Kind, Batch) \
    case KernelKind::Kind: return "zeroset_" #name;
#include "engine/kernel/kernel_functions.def"
        case KernelKind::RayValue: return "zeroset_ray_value";
        case KernelKind::Points: return "zeroset_points";
    }
    return "";
}

/// A function that is wanted; the graph must outlive it.
struct WantedCode {
    const Expr& expr;
    VectorKind vectors;
    KernelKind kind;
    bool hasty = false;  ///< as CompileOptions::hasty
};

/// Linked machine code; freed with the object.
class MachineCode {
public:
    MachineCode() = default;
    MachineCode(const MachineCode&) = delete;
    MachineCode& operator=(const MachineCode&) = delete;
    virtual ~MachineCode() = default;
    /// Address of the function; never 0.
    [[nodiscard]] std::uintptr_t entry() const { return entry_; }

protected:
    std::uintptr_t entry_ = 0;
};

using Code = std::expected<std::shared_ptr<const MachineCode>, CompileError>;
using CodeText = std::expected<std::string, CompileError>;

/// The functions of the module. Each needs a large stack for a deep graph, and rounding to nearest.
struct LlvmModule {
    Code (*make)(const WantedCode& wanted);
    CodeText (*ir)(const WantedCode& wanted);
    CodeText (*assembly)(const WantedCode& wanted);
};

/// The module's file: beside the program, or where it is installed in ../lib/zeroset
/// (CMakeLists.txt sets the program's search path). Its one function returns what it holds.
inline constexpr const char* llvm_module_file = "zeroset_llvm.so";
inline constexpr const char* llvm_module_function = "zeroset_llvm_module";
using LlvmModuleFunction = const LlvmModule* (*)();

/// The module, loaded by the first call and kept for good; or why it cannot be loaded. Thread-safe.
const std::expected<const LlvmModule*, CompileError>& llvm_module();

}  // namespace zeroset::jit
