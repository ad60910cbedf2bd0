#include "jit/llvm_module.hpp"

#include <dlfcn.h>

#include <atomic>

namespace zeroset::jit {
namespace {

using Loaded = std::expected<const LlvmModule*, CompileError>;

std::atomic<bool> is_missing = false;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

Loaded loaded_module() {
    void* const module = dlopen(llvm_module_file, RTLD_NOW | RTLD_LOCAL);
    void* const function = module == nullptr ? nullptr : dlsym(module, llvm_module_function);
    if (function != nullptr) return reinterpret_cast<LlvmModuleFunction>(function)();
    is_missing = true;
    const char* const error = dlerror();  // NOLINT(concurrency-mt-unsafe): glibc has one a thread
    return std::unexpected(CompileError{"no machine code can be made, and pictures take longer: " +
                                        std::string(error == nullptr ? llvm_module_file : error)});
}

}  // namespace

const Loaded& llvm_module() {
    static const Loaded module = loaded_module();
    return module;
}

bool can_compile() { return llvm_module().has_value(); }

std::optional<std::string> missing_code() {
    if (!is_missing) return std::nullopt;
    return llvm_module().error().message;
}

}  // namespace zeroset::jit
