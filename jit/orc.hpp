#pragma once

#include "engine/expr/expr.hpp"
#include "jit/compile.hpp"
#include "jit/lower.hpp"

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

// Private to jit/: what needs LLVM's execution engine.

namespace zeroset::jit {

/// Linked machine code; freed with the object.
class MachineCode {
public:
    virtual ~MachineCode() = default;
    /// Address of a function; never 0.
    [[nodiscard]] std::uintptr_t range() const { return range_; }
    [[nodiscard]] std::uintptr_t value() const { return value_; }
    [[nodiscard]] std::uintptr_t form() const { return form_; }

protected:
    std::uintptr_t range_ = 0;
    std::uintptr_t value_ = 0;
    std::uintptr_t form_ = 0;
};

/// Makes the module of a graph; `lower` makes that of kernels.
using Lowering = std::unique_ptr<llvm::Module> (*)(const Expr&, const VectorKind&,
                                                   llvm::LLVMContext&);

std::expected<std::shared_ptr<const MachineCode>, CompileError> make_code(
    const Expr& expr, const VectorKind& kind, Lowering lowering = lower);
std::expected<std::string, CompileError> print_ir(const Expr& expr, const VectorKind& kind);
std::expected<std::string, CompileError> print_assembly(const Expr& expr, const VectorKind& kind);

/// Runs `work` on a thread with a stack large enough for LLVM on a deep graph.
void run_on_large_stack(void (*work)(void*), void* argument);

}  // namespace zeroset::jit
