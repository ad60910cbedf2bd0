#pragma once

#include "engine/real/field.hpp"
#include "engine/real/format.hpp"
#include "engine/real/sleef.hpp"
#include "jit/llvm/lower.hpp"

#include <llvm/ADT/DenseMap.h>
#include <llvm/IR/IRBuilder.h>

#include <array>
#include <cstdint>
#include <span>
#include <tuple>

// The carrier that builds IR: the operations of engine/real/scalar.hpp, each on a vector of floats
// or doubles. Private to jit/.
//
// Arithmetic is emitted as constrained intrinsics with dynamic rounding, so that no pass may fold
// or reorder it as if rounding were to nearest; signs and comparisons are exact in every mode. LLVM
// finds no common subexpressions in such code, so Emitter::once emits each operation once only.
// Code is emitted in the order in which it runs: a value emitted before is available in all later
// code.

namespace zeroset::jit {

/// The place and width at which code is emitted. Outlives all Lanes made with it.
class Emitter {
public:
    Emitter(llvm::IRBuilder<>& code, const VectorKind& vectors) : builder(code), kind(vectors) {}

    llvm::IRBuilder<>& builder;
    VectorKind kind;

    [[nodiscard]] llvm::Type* vector_of(llvm::Type* element) const {
        return llvm::FixedVectorType::get(element, static_cast<unsigned>(kind.lanes));
    }
    [[nodiscard]] bool is_float() const { return kind.type == RealType::Float; }
    [[nodiscard]] llvm::Type* real() const {
        return is_float() ? builder.getFloatTy() : builder.getDoubleTy();
    }
    /// The integer type as wide as `real()`.
    [[nodiscard]] llvm::Type* integer() const {
        return is_float() ? builder.getInt32Ty() : builder.getInt64Ty();
    }
    [[nodiscard]] llvm::Type* real_vector() const { return vector_of(real()); }

    /// The result of an operation: of `make()` for new operands, else of the earlier emission.
    llvm::Value* once(unsigned operation, std::array<llvm::Value*, 3> operands, auto make) {
        auto& result = known_[{operation, operands[0], operands[1], operands[2]}];
        if (result == nullptr) result = make();
        return result;
    }

private:
    using Operation = std::tuple<unsigned, llvm::Value*, llvm::Value*, llvm::Value*>;
    llvm::DenseMap<Operation, llvm::Value*> known_;
};

struct LaneMask {
    Emitter* emitter;
    llvm::Value* value;  ///< <lanes x i1>
};

struct Lanes {
    Emitter* emitter;
    llvm::Value* value;  ///< <lanes x float> or <lanes x double>
};

Lanes operator+(const Lanes& a, const Lanes& b);
Lanes operator-(const Lanes& a, const Lanes& b);
Lanes operator*(const Lanes& a, const Lanes& b);
Lanes operator/(const Lanes& a, const Lanes& b);
Lanes operator-(const Lanes& a);

LaneMask operator>(const Lanes& a, const Lanes& b);
LaneMask operator<(const Lanes& a, const Lanes& b);
LaneMask operator>=(const Lanes& a, const Lanes& b);
LaneMask operator<=(const Lanes& a, const Lanes& b);
LaneMask operator==(const Lanes& a, const Lanes& b);
LaneMask unordered(const Lanes& a, const Lanes& b);
LaneMask both(const LaneMask& a, const LaneMask& b);
LaneMask either(const LaneMask& a, const LaneMask& b);
LaneMask no(const LaneMask& a);
/// Whether the masks are known to be the same.
inline bool identical(const LaneMask& a, const LaneMask& b) { return a.value == b.value; }

Lanes like(const Lanes& kind, double value);
Lanes maximum(const Lanes& a, const Lanes& b);
Lanes minimum(const Lanes& a, const Lanes& b);
Lanes select(const LaneMask& condition, const Lanes& if_true, const Lanes& if_false);
Lanes select_negative(const Lanes& x, const Lanes& if_set, const Lanes& if_clear);
Lanes square_root(const Lanes& a);
/// Whether the machine has an operation that rounds a product and a sum together.
bool can_fuse();
/// a b + c, rounded once where the machine can, else twice.
Lanes fused(const Lanes& a, const Lanes& b, const Lanes& c);
Lanes magnitude(const Lanes& a);
Lanes round_down(const Lanes& a);
Lanes elementary(Elementary function, const Lanes& a);
Lanes elementary(Elementary function, const Lanes& a, const Lanes& b);

/// The address of the function that asks a field in vectors of this type.
template <class Question>
std::uintptr_t asking_code(bool in_float) {
    return in_float ? reinterpret_cast<std::uintptr_t>(&ask<Question, float>)
                    : reinterpret_cast<std::uintptr_t>(&ask<Question, double>);
}
/// Emits the call of such a function; makes as many vectors as `out` holds.
void emit_question(std::uintptr_t code, const Field& field, int derivative,
                   std::span<const Lanes> in, std::span<Lanes> out);

/// The answers of a field (engine/real/field.hpp), which must outlive the code.
template <class Question>
std::array<Lanes, Question::answers> answers(Question /*question*/, const Field& field,
                                             int derivative,
                                             const std::array<Lanes, Question::questions>& in) {
    std::array<Lanes, Question::answers> out;
    emit_question(asking_code<Question>(in[0].emitter->is_float()), field, derivative, in, out);
    return out;
}

const Format& format_of(const Lanes& kind);

/// ray_roundings of engine/algebra/frustum.hpp: two more where products are rounded on their own.
double ray_roundings(const Lanes& kind);

}  // namespace zeroset::jit
