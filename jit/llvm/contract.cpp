#include "jit/llvm/contract.hpp"

#include "jit/llvm/lanes.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Intrinsics.h>
#include <llvm/IR/Module.h>

namespace zeroset::jit {
namespace {

using Rounded = llvm::ConstrainedFPIntrinsic;

/// Operand `k` of the sum if it is a product in the same block that nothing else uses, else
/// nullptr.
Rounded* product_in(const Rounded& sum, unsigned k) {
    auto* const product = llvm::dyn_cast<Rounded>(sum.getArgOperand(k));
    const bool fits = product != nullptr &&
                      product->getIntrinsicID() == llvm::Intrinsic::experimental_constrained_fmul &&
                      product->hasOneUse() && product->getParent() == sum.getParent();
    return fits ? product : nullptr;
}

/// Fuses `sum`, if it is a sum or difference, with a product in it.
void contract(Rounded& sum) {
    const bool minus = sum.getIntrinsicID() == llvm::Intrinsic::experimental_constrained_fsub;
    if (!minus && sum.getIntrinsicID() != llvm::Intrinsic::experimental_constrained_fadd) {
        return;
    }
    Rounded* const first = product_in(sum, 0);
    Rounded* const second = product_in(sum, 1);
    if (first == nullptr && second == nullptr) return;
    // Take the product that is ready last.
    const bool in_first = second == nullptr || (first != nullptr && second->comesBefore(first));
    Rounded* const product = in_first ? first : second;
    llvm::IRBuilder<> builder(&sum);
    llvm::Value* factor = product->getArgOperand(0);
    llvm::Value* rest = sum.getArgOperand(in_first ? 1 : 0);
    if (minus) (in_first ? rest : factor) = builder.CreateFNeg(in_first ? rest : factor);
    auto* const function = llvm::Intrinsic::getDeclaration(
        sum.getModule(), llvm::Intrinsic::experimental_constrained_fma, {sum.getType()});
    llvm::Value* const fused = builder.CreateConstrainedFPCall(
        function, {factor, product->getArgOperand(1), rest}, "", llvm::RoundingMode::Dynamic,
        llvm::fp::ExceptionBehavior::ebIgnore);
    sum.replaceAllUsesWith(fused);
    sum.eraseFromParent();
    product->eraseFromParent();
}

}  // namespace

void contract(llvm::Module& module) {
    if (!can_fuse()) return;
    for (llvm::Function& function : module) {
        for (llvm::BasicBlock& block : function) {
            for (llvm::Instruction& instruction : llvm::make_early_inc_range(block)) {
                if (auto* const sum = llvm::dyn_cast<Rounded>(&instruction)) contract(*sum);
            }
        }
    }
}

}  // namespace zeroset::jit
