#pragma once

namespace llvm {
class Module;
}

namespace zeroset::jit {

/// Fuses each product with the sum or difference that is its only user, where the machine can. A
/// fused operation rounds once instead of twice: bounds of the roundings of both still hold, and so
/// does what is true of a sum whatever the upward rounding of its product.
void contract(llvm::Module& module);

}  // namespace zeroset::jit
