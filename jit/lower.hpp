#pragma once

#include "engine/expr/expr.hpp"
#include "engine/expr/facts.hpp"
#include "engine/num/format.hpp"

#include <memory>
#include <span>

namespace llvm {
class LLVMContext;
class Module;
}  // namespace llvm

namespace zeroset::jit {

inline constexpr const char* range_symbol = "zeroset_range";
inline constexpr const char* value_symbol = "zeroset_value";
inline constexpr const char* form_symbol = "zeroset_form";

/// The vectors that code works on.
struct VectorKind {
    RealType type;
    int lanes;
};

/// A module with the batch functions of kernel.hpp over such vectors. Each is one loop: what
/// depends on w and the parameters only is computed before it.
std::unique_ptr<llvm::Module> lower(const Expr& expr, const VectorKind& kind,
                                    llvm::LLVMContext& context);

/// Only the function over points.
void add_value_function(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                        llvm::Module& module);

}  // namespace zeroset::jit
