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

/// The batch functions of engine/kernel/kernel.hpp.
enum class KernelPart : std::uint8_t {
    Range,
    Value,
    Form,
    RayForm,
    Newton,
    RayValue,
    Points,  ///< the values alone, for a PointFunction
};

/// The parts of a Kernel.
inline constexpr KernelPart kernel_parts[] = {KernelPart::Range,  KernelPart::Value,
                                              KernelPart::Form,   KernelPart::RayForm,
                                              KernelPart::Newton, KernelPart::RayValue};

/// The name of the part's function.
const char* symbol_of(KernelPart part);

/// A module with one batch function over vectors of this kind: a loop over the items, with all that
/// depends only on w and the parameters computed before it.
std::unique_ptr<llvm::Module> lower(const Expr& expr, const VectorKind& kind, KernelPart part,
                                    llvm::LLVMContext& context);

}  // namespace zeroset::jit
