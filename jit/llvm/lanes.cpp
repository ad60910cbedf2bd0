#include "jit/llvm/lanes.hpp"

#include "engine/num/elementary.hpp"
#include "engine/real/processor.hpp"

#include <llvm/IR/Intrinsics.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

namespace zeroset::jit {
namespace {

// Keys of Emitter::once for operations that are not intrinsics.
enum Operation : unsigned {
    Negation = 1U << 24U,
    Choice,
    SignChoice,
    Both,
    Either,
    Complement,
    Comparison,               ///< plus the predicate
    LibraryCall = 1U << 25U,  ///< plus the function
};

/// The operands in an order that is the same for a, b and b, a.
std::array<llvm::Value*, 3> unordered_pair(llvm::Value* a, llvm::Value* b,
                                           llvm::Value* c = nullptr) {
    return std::less<>()(a, b) ? std::array{a, b, c} : std::array{b, a, c};
}

Lanes intrinsic(llvm::Intrinsic::ID id, const Lanes& a) {
    const auto make = [&] { return a.emitter->builder.CreateUnaryIntrinsic(id, a.value); };
    return {.emitter = a.emitter, .value = a.emitter->once(id, {a.value}, make)};
}

/// An operation that rounds in the mode set when it runs. `key`: the operands for Emitter::once.
Lanes rounded(llvm::Intrinsic::ID id, const Lanes& a, llvm::ArrayRef<llvm::Value*> operands,
              const std::array<llvm::Value*, 3>& key) {
    const auto make = [&]() -> llvm::Value* {
        llvm::IRBuilder<>& builder = a.emitter->builder;
        auto* const function = llvm::Intrinsic::getDeclaration(
            builder.GetInsertBlock()->getModule(), id, {a.value->getType()});
        return builder.CreateConstrainedFPCall(function, operands, "", llvm::RoundingMode::Dynamic,
                                               llvm::fp::ExceptionBehavior::ebIgnore);
    };
    return {.emitter = a.emitter, .value = a.emitter->once(id, key, make)};
}

/// Whether `a` is this number in all lanes.
bool is_number(const Lanes& a, double number) {
    const auto* const constant = llvm::dyn_cast<llvm::Constant>(a.value);
    const auto* const splat =
        constant == nullptr ? nullptr
                            : llvm::dyn_cast_or_null<llvm::ConstantFP>(constant->getSplatValue());
    return splat != nullptr && splat->isExactlyValue(number);
}

LaneMask logical(Operation operation, const LaneMask& a, const LaneMask& b, auto make) {
    return {a.emitter, a.emitter->once(operation, unordered_pair(a.value, b.value), make)};
}

LaneMask compare(llvm::CmpInst::Predicate predicate, const Lanes& a, const Lanes& b) {
    const auto make = [&] { return a.emitter->builder.CreateFCmp(predicate, a.value, b.value); };
    return {.emitter = a.emitter,
            .value = a.emitter->once(
                static_cast<unsigned>(Comparison) + static_cast<unsigned>(predicate),
                {a.value, b.value}, make)};
}

Lanes call(const Lanes& kind, Elementary function, llvm::ArrayRef<llvm::Value*> arguments) {
    const auto make = [&]() -> llvm::Value* {
        llvm::IRBuilder<>& builder = kind.emitter->builder;
        const VectorKind& vectors = kind.emitter->kind;
        llvm::Type* const vector = kind.emitter->real_vector();
        const std::vector<llvm::Type*> parameters(arguments.size(), vector);
        auto* const type = llvm::FunctionType::get(vector, parameters, false);
        const auto address = reinterpret_cast<std::uintptr_t>(
            elementary_code(function, vectors.lanes, vectors.type));
        llvm::Value* const code =
            builder.CreateIntToPtr(builder.getInt64(address), builder.getPtrTy());
        llvm::CallInst* const made = builder.CreateCall(type, code, arguments);
        // The call keeps the rounding mode, and may be removed where its result is unused.
        made->setDoesNotAccessMemory();
        made->setDoesNotThrow();
        made->addFnAttr(llvm::Attribute::WillReturn);
        return made;
    };
    std::array<llvm::Value*, 3> key{};
    std::ranges::copy(arguments, key.begin());
    const auto operation = static_cast<unsigned>(LibraryCall) + static_cast<unsigned>(function);
    return {.emitter = kind.emitter, .value = kind.emitter->once(operation, key, make)};
}

}  // namespace

bool can_fuse() { return machine_has_fma(); }

Lanes operator+(const Lanes& a, const Lanes& b) {
    return rounded(llvm::Intrinsic::experimental_constrained_fadd, a, {a.value, b.value},
                   unordered_pair(a.value, b.value));
}
Lanes operator-(const Lanes& a, const Lanes& b) {
    return rounded(llvm::Intrinsic::experimental_constrained_fsub, a, {a.value, b.value},
                   {a.value, b.value});
}
Lanes operator*(const Lanes& a, const Lanes& b) {
    // Exact in every mode; gradients have many such factors.
    if (is_number(a, 1.0)) return b;
    if (is_number(b, 1.0)) return a;
    return rounded(llvm::Intrinsic::experimental_constrained_fmul, a, {a.value, b.value},
                   unordered_pair(a.value, b.value));
}
Lanes operator/(const Lanes& a, const Lanes& b) {
    return rounded(llvm::Intrinsic::experimental_constrained_fdiv, a, {a.value, b.value},
                   {a.value, b.value});
}
Lanes operator-(const Lanes& a) {
    const auto make = [&] { return a.emitter->builder.CreateFNeg(a.value); };
    return {.emitter = a.emitter, .value = a.emitter->once(Negation, {a.value}, make)};
}

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
    return logical(Both, a, b, [&] { return a.emitter->builder.CreateAnd(a.value, b.value); });
}
LaneMask either(const LaneMask& a, const LaneMask& b) {
    return logical(Either, a, b, [&] { return a.emitter->builder.CreateOr(a.value, b.value); });
}
LaneMask no(const LaneMask& a) {
    return logical(Complement, a, a, [&] { return a.emitter->builder.CreateNot(a.value); });
}

Lanes like(const Lanes& kind, double value) {
    return {.emitter = kind.emitter,
            .value = llvm::ConstantFP::get(kind.emitter->real_vector(), value)};
}

Lanes maximum(const Lanes& a, const Lanes& b) { return select(a > b, a, b); }
Lanes minimum(const Lanes& a, const Lanes& b) { return select(a < b, a, b); }

Lanes select(const LaneMask& condition, const Lanes& if_true, const Lanes& if_false) {
    Emitter* const emitter = if_true.emitter;
    const auto make = [&] {
        return emitter->builder.CreateSelect(condition.value, if_true.value, if_false.value);
    };
    return {.emitter = emitter,
            .value = emitter->once(Choice, {condition.value, if_true.value, if_false.value}, make)};
}

Lanes select_negative(const Lanes& x, const Lanes& if_set, const Lanes& if_clear) {
    const auto make = [&] {
        llvm::IRBuilder<>& builder = x.emitter->builder;
        llvm::Type* const integers = x.emitter->vector_of(x.emitter->integer());
        llvm::Value* const bits = builder.CreateBitCast(x.value, integers);
        llvm::Value* const is_set =
            builder.CreateICmpSLT(bits, llvm::Constant::getNullValue(integers));
        return builder.CreateSelect(is_set, if_set.value, if_clear.value);
    };
    return {.emitter = x.emitter,
            .value = x.emitter->once(SignChoice, {x.value, if_set.value, if_clear.value}, make)};
}

Lanes square_root(const Lanes& a) {
    return rounded(llvm::Intrinsic::experimental_constrained_sqrt, a, {a.value}, {a.value});
}

double ray_roundings(const Lanes& /*kind*/) { return can_fuse() ? 4.0 : 6.0; }

Lanes fused(const Lanes& a, const Lanes& b, const Lanes& c) {
    if (!can_fuse()) return a * b + c;
    return rounded(llvm::Intrinsic::experimental_constrained_fma, a, {a.value, b.value, c.value},
                   unordered_pair(a.value, b.value, c.value));
}

Lanes magnitude(const Lanes& a) { return intrinsic(llvm::Intrinsic::fabs, a); }
Lanes round_down(const Lanes& a) { return intrinsic(llvm::Intrinsic::floor, a); }

Lanes elementary(Elementary function, const Lanes& a) { return call(a, function, {a.value}); }
Lanes elementary(Elementary function, const Lanes& a, const Lanes& b) {
    return call(a, function, {a.value, b.value});
}

void emit_question(std::uintptr_t code, const Field& field, int derivative,
                   std::span<const Lanes> in, std::span<Lanes> out) {
    Emitter* const emitter = in.front().emitter;
    llvm::IRBuilder<>& builder = emitter->builder;
    llvm::Type* const vector = emitter->real_vector();
    // Room for the vectors at the function's entry, once for all turns of its loop.
    const auto room_for = [&](std::size_t vectors) {
        llvm::BasicBlock& entry = builder.GetInsertBlock()->getParent()->getEntryBlock();
        llvm::IRBuilder<> at_entry(&entry, entry.begin());
        return at_entry.CreateAlloca(vector, at_entry.getInt32(static_cast<unsigned>(vectors)));
    };
    llvm::Value* const questions = room_for(in.size());
    llvm::Value* const room = room_for(out.size());
    for (std::size_t i = 0; i < in.size(); ++i)
        builder.CreateStore(in[i].value, builder.CreateConstGEP1_64(vector, questions, i));
    const auto pointer = [&](std::uintptr_t address) {
        return builder.CreateIntToPtr(builder.getInt64(address), builder.getPtrTy());
    };
    llvm::Type* const whole = builder.getInt32Ty();
    llvm::Type* const any = builder.getPtrTy();
    auto* const type =
        llvm::FunctionType::get(builder.getVoidTy(), {any, whole, any, any, whole}, false);
    builder
        .CreateCall(type, pointer(code),
                    {pointer(reinterpret_cast<std::uintptr_t>(&field)),
                     builder.getInt32(static_cast<std::uint32_t>(derivative)), questions, room,
                     builder.getInt32(static_cast<std::uint32_t>(emitter->kind.lanes))})
        ->setDoesNotThrow();
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = {.emitter = emitter,
                  .value = builder.CreateLoad(vector, builder.CreateConstGEP1_64(vector, room, i))};
    }
}

const Format& format_of(const Lanes& kind) {
    return kind.emitter->is_float() ? float_format : double_format;
}

}  // namespace zeroset::jit
