#pragma once

#include "engine/expr/expr.hpp"
#include "jit/compile.hpp"
#include "jit/lower.hpp"

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <string>

// The interface to LLVM's execution engine. Private to jit/.

namespace zeroset::jit {

/// Linked machine code; freed with the object.
class MachineCode {
public:
    virtual ~MachineCode() = default;
    /// Address of the function; never 0.
    [[nodiscard]] std::uintptr_t entry() const { return entry_; }

protected:
    std::uintptr_t entry_ = 0;
};

/// A function that makes a module with one function.
using Lowering = std::function<std::unique_ptr<llvm::Module>(llvm::LLVMContext&)>;

/// The lowering by `lower`; the graph must outlive it.
Lowering lowering_of(const Expr& expr, const VectorKind& kind, KernelKind part);

/// Compiles and links the module; `symbol` is its function, `hasty` CompileOptions::hasty.
std::expected<std::shared_ptr<const MachineCode>, CompileError> make_code(const Lowering& lowering,
                                                                          const char* symbol,
                                                                          bool hasty);
std::expected<std::string, CompileError> print_ir(const Lowering& lowering);
std::expected<std::string, CompileError> print_assembly(const Lowering& lowering);

/// Runs `work` on a thread with a stack large enough for LLVM on a deep graph.
void run_on_large_stack(void (*work)(void*), void* argument);

}  // namespace zeroset::jit
