#pragma once

namespace llvm {
class Module;
}

namespace zeroset::jit {

/// Makes one operation of each product with the sum or difference that alone uses it, where the
/// machine can. That rounds once instead of twice: what bounds the roundings of both holds, and so
/// does what holds of a sum however far its product was rounded upward.
void contract(llvm::Module& module);

}  // namespace zeroset::jit
