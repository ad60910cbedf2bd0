#pragma once

#include "engine/num/sleef.hpp"

#include <llvm/IR/IRBuilder.h>

// The carrier that builds IR: the same operations as engine/num/scalar.hpp, each on a vector of
// floats. Private to jit/.
//
// Arithmetic is emitted as constrained intrinsics with dynamic rounding, so no pass may fold or
// reorder it as if rounding were to nearest; signs and comparisons are exact in every mode.

namespace zeroset::jit {

/// Where and how wide code is emitted. Outlives all Lanes made with it.
struct Emitter {
    llvm::IRBuilder<>& builder;
    int lanes;

    [[nodiscard]] llvm::Type* vector_of(llvm::Type* element) const {
        return llvm::FixedVectorType::get(element, static_cast<unsigned>(lanes));
    }
    [[nodiscard]] llvm::Type* float_vector() const { return vector_of(builder.getFloatTy()); }
    [[nodiscard]] llvm::Value* constrained(llvm::Intrinsic::ID id, llvm::Value* a,
                                           llvm::Value* b) const;
};

struct LaneMask {
    Emitter* emitter;
    llvm::Value* value;  ///< <lanes x i1>
};

struct Lanes {
    Emitter* emitter;
    llvm::Value* value;  ///< <lanes x float>
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
Lanes magnitude(const Lanes& a);
Lanes round_down(const Lanes& a);
Lanes elementary(Elementary function, const Lanes& a);
Lanes elementary(Elementary function, const Lanes& a, const Lanes& b);

// The numbers of float.
bool representable(double value, const Lanes& kind);
double relative_gap(const Lanes& kind);
double smallest_normal(const Lanes& kind);
double largest_finite(const Lanes& kind);

}  // namespace zeroset::jit
