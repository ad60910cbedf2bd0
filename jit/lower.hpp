#pragma once

#include "engine/expr/expr.hpp"
#include "engine/real/format.hpp"

#include <cstdint>
#include <memory>

namespace llvm {
class LLVMContext;
class Module;
}  // namespace llvm

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

/// The name of the function in its module.
const char* symbol_of(KernelKind kind);

/// A module with one batch function over vectors of this kind: a loop over the items, with all that
/// depends only on w and the parameters computed before it.
std::unique_ptr<llvm::Module> lower(const Expr& expr, const VectorKind& kind, KernelKind part,
                                    llvm::LLVMContext& context);

}  // namespace zeroset::jit
