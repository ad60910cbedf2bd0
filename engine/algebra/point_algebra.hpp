#pragma once

#include "engine/algebra/dual_algebra.hpp"

namespace zeroset {

/// The values that DualAlgebra computes, without slopes.
template <class Real>
class PointAlgebra {
public:
    using Value = Real;
    using In = const Operand<Value>&;

#define ZEROSET_POINT_1(method) \
    Value method(In a) { return duals_.method(Plain(a).operand()).value; }
#define ZEROSET_POINT_2(method) \
    Value method(In a, In b) { return duals_.method(Plain(a).operand(), Plain(b).operand()).value; }
#define ZEROSET_POINT_3(method)                                                                 \
    Value method(In a, In b, In c) {                                                            \
        return duals_.method(Plain(a).operand(), Plain(b).operand(), Plain(c).operand()).value; \
    }
#define ZEROSET_OP_Prefix(method, arity) ZEROSET_POINT_##arity(method)
#define ZEROSET_OP_Infix(method, arity) ZEROSET_POINT_##arity(method)
#define ZEROSET_OP_Power(method, arity) \
    Value method(In a, int n) { return duals_.method(Plain(a).operand(), n).value; }
#define ZEROSET_OP_Root(method, arity) ZEROSET_OP_Power(method, arity)
#define ZEROSET_OP_Wave(method, arity)                                         \
    Value method(In a, In b, int n) {                                          \
        return duals_.method(Plain(a).operand(), Plain(b).operand(), n).value; \
    }
#define ZEROSET_OP_Lookup(method, arity)                                                           \
    Value method(In a, In b, In c, const Field& field, int derivative) {                           \
        return duals_                                                                              \
            .method(Plain(a).operand(), Plain(b).operand(), Plain(c).operand(), field, derivative) \
            .value;                                                                                \
    }
#define ZEROSET_OP_Call(method, arity) ZEROSET_POINT_##arity(method)
#define ZEROSET_OP_Compare(method, arity) ZEROSET_POINT_##arity(method)
#define ZEROSET_OP_Logic(method, arity) ZEROSET_POINT_##arity(method)
#define ZEROSET_OP_Internal(method, arity) ZEROSET_POINT_##arity(method)
#define ZEROSET_OP(id, method, spelling, arity, notation, about) \
    ZEROSET_OP_##notation(method, arity)
#include "engine/expr/op.def"
#undef ZEROSET_OP
#undef ZEROSET_OP_Prefix
#undef ZEROSET_OP_Infix
#undef ZEROSET_OP_Power
#undef ZEROSET_OP_Root
#undef ZEROSET_OP_Wave
#undef ZEROSET_OP_Lookup
#undef ZEROSET_OP_Call
#undef ZEROSET_OP_Compare
#undef ZEROSET_OP_Logic
#undef ZEROSET_OP_Internal
#undef ZEROSET_POINT_1
#undef ZEROSET_POINT_2
#undef ZEROSET_POINT_3

private:
    /// An operand without slopes.
    class Plain {
    public:
        explicit Plain(In a) : value_{a.value, {}}, operand_{value_, a.facts} {}
        Plain(const Plain&) = delete;
        Plain& operator=(const Plain&) = delete;
        ~Plain() = default;
        [[nodiscard]] const Operand<Dual<Real>>& operand() const { return operand_; }

    private:
        Dual<Real> value_;
        Operand<Dual<Real>> operand_;
    };

    DualAlgebra<Real> duals_;
};

}  // namespace zeroset
