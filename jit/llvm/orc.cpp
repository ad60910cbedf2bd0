#include "jit/llvm/orc.hpp"

#include "engine/real/processor.hpp"

#include <llvm/ADT/SmallVector.h>
#include <llvm/ExecutionEngine/Orc/LLJIT.h>
#include <llvm/IR/LegacyPassManager.h>
#include <llvm/IR/Module.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/Target/TargetMachine.h>

#include <mutex>

namespace zeroset::jit {
namespace {

namespace orc = llvm::orc;

CompileError message_of(llvm::Error error) { return {llvm::toString(std::move(error))}; }

/// A target for this machine's processor and features, with floating point exactly as written.
llvm::Expected<orc::JITTargetMachineBuilder> host_target(bool hasty) {
    static std::once_flag once;
    std::call_once(once, [] {
        llvm::InitializeNativeTarget();
        llvm::InitializeNativeTargetAsmPrinter();
    });
    auto target = orc::JITTargetMachineBuilder::detectHost();
    if (!target) return target;
    // Leave out the registers that ZEROSET_WIDEST forbids.
    if (widest_registers_allowed() < 64) target->getFeatures().AddFeature("avx512f", false);
    if (widest_registers_allowed() < 32) target->getFeatures().AddFeature("avx", false);
    target->getOptions().AllowFPOpFusion = llvm::FPOpFusion::Strict;
    target->setCodeGenOptLevel(hasty ? llvm::CodeGenOptLevel::None : llvm::CodeGenOptLevel::Less);
    return target;
}

class OrcCode final : public MachineCode {
public:
    OrcCode(std::unique_ptr<orc::LLJIT> jit, std::uintptr_t entry) : jit_(std::move(jit)) {
        entry_ = entry;
    }

private:
    std::unique_ptr<orc::LLJIT> jit_;
};

llvm::Expected<std::shared_ptr<const MachineCode>> link(const Lowering& lowering,
                                                        const char* symbol, bool hasty) {
    auto target = host_target(hasty);
    if (!target) return target.takeError();
    auto jit = orc::LLJITBuilder().setJITTargetMachineBuilder(*target).create();
    if (!jit) return jit.takeError();
    auto context = std::make_unique<llvm::LLVMContext>();
    std::unique_ptr<llvm::Module> module = lowering(*context);
    module->setDataLayout((*jit)->getDataLayout());
    if (auto error =
            (*jit)->addIRModule(orc::ThreadSafeModule(std::move(module), std::move(context)))) {
        return error;
    }
    auto entry = (*jit)->lookup(symbol);
    if (!entry) return entry.takeError();
    return std::make_shared<OrcCode>(std::move(*jit), entry->getValue());
}

}  // namespace

Code make_code(const Lowering& lowering, const char* symbol, bool hasty) {
    auto code = link(lowering, symbol, hasty);
    if (!code) return std::unexpected(message_of(code.takeError()));
    return *code;
}

CodeText print_ir(const Lowering& lowering) {
    llvm::LLVMContext context;
    std::string text;
    llvm::raw_string_ostream(text) << *lowering(context);
    return text;
}

CodeText print_assembly(const Lowering& lowering) {
    auto target = host_target(false);
    if (!target) return std::unexpected(message_of(target.takeError()));
    auto machine = target->createTargetMachine();
    if (!machine) return std::unexpected(message_of(machine.takeError()));
    llvm::LLVMContext context;
    const std::unique_ptr<llvm::Module> module = lowering(context);
    module->setDataLayout((*machine)->createDataLayout());
    module->setTargetTriple((*machine)->getTargetTriple().str());
    llvm::SmallVector<char> text;
    llvm::raw_svector_ostream stream(text);
    llvm::legacy::PassManager passes;
    if ((*machine)->addPassesToEmitFile(passes, stream, nullptr,
                                        llvm::CodeGenFileType::AssemblyFile)) {
        return std::unexpected(CompileError{"LLVM cannot print assembly for this machine"});
    }
    passes.run(*module);
    return std::string(text.begin(), text.end());
}

}  // namespace zeroset::jit
