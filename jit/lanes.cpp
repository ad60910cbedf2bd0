#include "jit/lanes.hpp"

#include "engine/num/elementary.hpp"

#include <llvm/IR/Intrinsics.h>

namespace zeroset::jit {
namespace {

/// Whether the machine rounds a product and a sum together.
bool can_fuse() { return __builtin_cpu_supports("fma"); }

Lanes arithmetic(llvm::Intrinsic::ID id, const Lanes& a, const Lanes& b) {
    return {a.emitter, a.emitter->constrained(id, a.value, b.value)};
}

LaneMask compare(llvm::CmpInst::Predicate predicate, const Lanes& a, const Lanes& b) {
    return {a.emitter, a.emitter->builder.CreateFCmp(predicate, a.value, b.value)};
}

Lanes call(const Lanes& kind, Elementary function, llvm::ArrayRef<llvm::Value*> arguments) {
    llvm::IRBuilder<>& builder = kind.emitter->builder;
    const VectorKind& vectors = kind.emitter->kind;
    llvm::Type* const vector = kind.emitter->real_vector();
    const std::vector<llvm::Type*> parameters(arguments.size(), vector);
    auto* const type = llvm::FunctionType::get(vector, parameters, false);
    const auto address =
        reinterpret_cast<std::uintptr_t>(elementary_code(function, vectors.lanes, vectors.type));
    llvm::Value* const code = builder.CreateIntToPtr(builder.getInt64(address), builder.getPtrTy());
    llvm::CallInst* const made = builder.CreateCall(type, code, arguments);
    // It leaves the rounding mode as it was, and may be left out.
    made->setDoesNotAccessMemory();
    made->setDoesNotThrow();
    made->addFnAttr(llvm::Attribute::WillReturn);
    return {kind.emitter, made};
}

}  // namespace

llvm::Value* Emitter::constrained(llvm::Intrinsic::ID id, llvm::Value* a, llvm::Value* b) const {
    return builder.CreateConstrainedFPBinOp(id, a, b, nullptr, "", nullptr,
                                            llvm::RoundingMode::Dynamic,
                                            llvm::fp::ExceptionBehavior::ebIgnore);
}

Lanes operator+(const Lanes& a, const Lanes& b) {
    return arithmetic(llvm::Intrinsic::experimental_constrained_fadd, a, b);
}
Lanes operator-(const Lanes& a, const Lanes& b) {
    return arithmetic(llvm::Intrinsic::experimental_constrained_fsub, a, b);
}
Lanes operator*(const Lanes& a, const Lanes& b) {
    return arithmetic(llvm::Intrinsic::experimental_constrained_fmul, a, b);
}
Lanes operator/(const Lanes& a, const Lanes& b) {
    return arithmetic(llvm::Intrinsic::experimental_constrained_fdiv, a, b);
}
Lanes operator-(const Lanes& a) { return {a.emitter, a.emitter->builder.CreateFNeg(a.value)}; }

LaneMask operator>(const Lanes& a, const Lanes& b) {
    return compare(llvm::CmpInst::FCMP_OGT, a, b);
}
LaneMask operator<(const Lanes& a, const Lanes& b) {
    return compare(llvm::CmpInst::FCMP_OLT, a, b);
}
LaneMask operator>=(const Lanes& a, const Lanes& b) {
    return compare(llvm::CmpInst::FCMP_OGE, a, b);
}
LaneMask operator<=(const Lanes& a, const Lanes& b) {
    return compare(llvm::CmpInst::FCMP_OLE, a, b);
}
LaneMask operator==(const Lanes& a, const Lanes& b) {
    return compare(llvm::CmpInst::FCMP_OEQ, a, b);
}
LaneMask unordered(const Lanes& a, const Lanes& b) {
    return compare(llvm::CmpInst::FCMP_UNO, a, b);
}

LaneMask both(const LaneMask& a, const LaneMask& b) {
    return {a.emitter, a.emitter->builder.CreateAnd(a.value, b.value)};
}
LaneMask either(const LaneMask& a, const LaneMask& b) {
    return {a.emitter, a.emitter->builder.CreateOr(a.value, b.value)};
}
LaneMask no(const LaneMask& a) { return {a.emitter, a.emitter->builder.CreateNot(a.value)}; }

Lanes like(const Lanes& kind, double value) {
    return {kind.emitter, llvm::ConstantFP::get(kind.emitter->real_vector(), value)};
}

Lanes maximum(const Lanes& a, const Lanes& b) { return select(a > b, a, b); }
Lanes minimum(const Lanes& a, const Lanes& b) { return select(a < b, a, b); }

Lanes select(const LaneMask& condition, const Lanes& if_true, const Lanes& if_false) {
    return {if_true.emitter,
            if_true.emitter->builder.CreateSelect(condition.value, if_true.value, if_false.value)};
}

Lanes select_negative(const Lanes& x, const Lanes& if_set, const Lanes& if_clear) {
    llvm::IRBuilder<>& builder = x.emitter->builder;
    llvm::Type* const integers = x.emitter->vector_of(x.emitter->integer());
    llvm::Value* const bits = builder.CreateBitCast(x.value, integers);
    llvm::Value* const is_set = builder.CreateICmpSLT(bits, llvm::Constant::getNullValue(integers));
    return {x.emitter, builder.CreateSelect(is_set, if_set.value, if_clear.value)};
}

Lanes square_root(const Lanes& a) {
    llvm::IRBuilder<>& builder = a.emitter->builder;
    auto* const root = llvm::Intrinsic::getDeclaration(
        builder.GetInsertBlock()->getModule(), llvm::Intrinsic::experimental_constrained_sqrt,
        {a.value->getType()});
    return {a.emitter,
            builder.CreateConstrainedFPCall(root, {a.value}, "", llvm::RoundingMode::Dynamic,
                                            llvm::fp::ExceptionBehavior::ebIgnore)};
}

double ray_roundings(const Lanes& /*kind*/) { return can_fuse() ? 4.0 : 6.0; }

Lanes fused(const Lanes& a, const Lanes& b, const Lanes& c) {
    if (!can_fuse()) return a * b + c;
    llvm::IRBuilder<>& builder = a.emitter->builder;
    auto* const fma = llvm::Intrinsic::getDeclaration(builder.GetInsertBlock()->getModule(),
                                                      llvm::Intrinsic::experimental_constrained_fma,
                                                      {a.value->getType()});
    return {a.emitter, builder.CreateConstrainedFPCall(fma, {a.value, b.value, c.value}, "",
                                                       llvm::RoundingMode::Dynamic,
                                                       llvm::fp::ExceptionBehavior::ebIgnore)};
}

Lanes magnitude(const Lanes& a) {
    return {a.emitter, a.emitter->builder.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, a.value)};
}
Lanes round_down(const Lanes& a) {
    return {a.emitter, a.emitter->builder.CreateUnaryIntrinsic(llvm::Intrinsic::floor, a.value)};
}

Lanes elementary(Elementary function, const Lanes& a) { return call(a, function, {a.value}); }
Lanes elementary(Elementary function, const Lanes& a, const Lanes& b) {
    return call(a, function, {a.value, b.value});
}

const Format& format_of(const Lanes& kind) {
    return kind.emitter->is_float() ? float_format : double_format;
}

}  // namespace zeroset::jit
