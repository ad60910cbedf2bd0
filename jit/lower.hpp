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

/// The vectors that code works on.
struct VectorKind {
    RealType type;
    int lanes;
};

/// The batch functions of kernel.hpp.
enum class KernelPart : std::uint8_t {
    Range,
    Value,
    Form,
    RayForm,
    Newton,
    RayValue,
    Points,  ///< of a PointFunction: the values alone
};

/// Those of a Kernel.
inline constexpr KernelPart kernel_parts[] = {KernelPart::Range,  KernelPart::Value,
                                              KernelPart::Form,   KernelPart::RayForm,
                                              KernelPart::Newton, KernelPart::RayValue};

/// The name of its function.
const char* symbol_of(KernelPart part);

/// A module with one batch function over such vectors: a loop; what depends on w and the parameters
/// only is computed before it.
std::unique_ptr<llvm::Module> lower(const Expr& expr, const VectorKind& kind, KernelPart part,
                                    llvm::LLVMContext& context);

}  // namespace zeroset::jit
