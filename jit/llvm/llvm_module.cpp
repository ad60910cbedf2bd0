#include "jit/llvm_module.hpp"

#include "jit/llvm/orc.hpp"

#include <llvm/IR/Module.h>

// The door of the module zeroset_llvm.so.

namespace zeroset::jit {
namespace {

Lowering lowering_of(const WantedCode& wanted) {
    return [wanted](llvm::LLVMContext& context) {
        return lower(wanted.expr, wanted.vectors, wanted.kind, context);
    };
}

Code make(const WantedCode& wanted) {
    return make_code(lowering_of(wanted), symbol_of(wanted.kind), wanted.hasty);
}

CodeText ir(const WantedCode& wanted) { return print_ir(lowering_of(wanted)); }

CodeText assembly(const WantedCode& wanted) { return print_assembly(lowering_of(wanted)); }

}  // namespace
}  // namespace zeroset::jit

// NOLINTNEXTLINE(misc-use-internal-linkage): found by its name
extern "C" __attribute__((visibility("default"))) const zeroset::jit::LlvmModule*
zeroset_llvm_module() {
    using namespace zeroset::jit;  // NOLINT(google-build-using-namespace)
    static constexpr LlvmModule module{.make = make, .ir = ir, .assembly = assembly};
    return &module;
}
