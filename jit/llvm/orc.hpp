#pragma once

#include "jit/llvm/lower.hpp"
#include "jit/llvm_module.hpp"

#include <functional>
#include <memory>

// The interface to LLVM's execution engine.

namespace zeroset::jit {

/// A function that makes a module with one function.
using Lowering = std::function<std::unique_ptr<llvm::Module>(llvm::LLVMContext&)>;

/// Compiles and links the module; `symbol` is its function, `hasty` CompileOptions::hasty.
Code make_code(const Lowering& lowering, const char* symbol, bool hasty);
CodeText print_ir(const Lowering& lowering);
CodeText print_assembly(const Lowering& lowering);

}  // namespace zeroset::jit
