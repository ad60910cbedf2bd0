#pragma once

#include "engine/expr/expr.hpp"
#include "jit/llvm_module.hpp"

#include <memory>

namespace llvm {
class LLVMContext;
class Module;
}  // namespace llvm

namespace zeroset::jit {

/// A module with one batch function over vectors of this kind: a loop over the items, with all that
/// depends only on w and the parameters computed before it.
std::unique_ptr<llvm::Module> lower(const Expr& expr, const VectorKind& kind, KernelKind part,
                                    llvm::LLVMContext& context);

}  // namespace zeroset::jit
