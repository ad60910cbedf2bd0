#include "engine/base/module.hpp"
#include "jit/llvm_module.hpp"

#include <atomic>

namespace zeroset::jit {
namespace {

using Loaded = std::expected<const LlvmModule*, CompileError>;

std::atomic<bool> is_missing = false;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

Loaded loaded_module() {
    const auto function = load_module(llvm_module_file, llvm_module_function);
    if (function) return reinterpret_cast<LlvmModuleFunction>(*function)();
    is_missing = true;
    return std::unexpected(
        CompileError{"no machine code can be made, and pictures take longer: " + function.error()});
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
