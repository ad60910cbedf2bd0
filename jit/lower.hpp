#pragma once

#include "engine/expr/expr.hpp"

#include <memory>

namespace llvm {
class LLVMContext;
class Module;
}  // namespace llvm

namespace zeroset::jit {

inline constexpr const char* range_symbol = "zeroset_range";
inline constexpr const char* value_symbol = "zeroset_value";

/// A module with the batch functions of kernel.hpp over vectors of `lanes` floats. Each is one
/// loop: what depends on w and the parameters only is computed before it.
std::unique_ptr<llvm::Module> lower(const Expr& expr, int lanes, llvm::LLVMContext& context);

}  // namespace zeroset::jit
