#pragma once

#include "engine/algebra/dual_algebra.hpp"
#include "engine/algebra/interval_algebra.hpp"
#include "engine/algebra/switches.hpp"

#include <optional>
#include <span>
#include <vector>

// An algebra tells the meaning of operators: one member for each row of op.def, over any carrier.
// The interpreter and the JIT apply the same algebras, so they perform the same operations.

namespace zeroset {

/// One operator on its operands. Those that it does not have are any value.
template <class Algebra>
typename Algebra::Value apply(Algebra& algebra, const Node& node,
                              const Operand<typename Algebra::Value>& a,
                              const Operand<typename Algebra::Value>& b,
                              const Operand<typename Algebra::Value>& c) {
    switch (node.op) {
        case Op::Constant:
        case Op::Variable: break;
        case Op::IntPower: return algebra.int_power(a, node.number);
        case Op::OddRoot: return algebra.odd_root(a, node.number);
        case Op::AngleSin: return algebra.angle_sin(a, b, node.number);
        case Op::AngleCos: return algebra.angle_cos(a, b, node.number);
        case Op::Field: return algebra.field(a, b, c, *node.field, node.number);
#define ZEROSET_APPLY_1(id, method) \
    case Op::id: return algebra.method(a);
#define ZEROSET_APPLY_2(id, method) \
    case Op::id: return algebra.method(a, b);
#define ZEROSET_APPLY_3(id, method) \
    case Op::id: return algebra.method(a, b, c);
#define ZEROSET_OP_Prefix(id, method, arity) ZEROSET_APPLY_##arity(id, method)
#define ZEROSET_OP_Infix(id, method, arity) ZEROSET_APPLY_##arity(id, method)
#define ZEROSET_OP_Power(id, method, arity)
#define ZEROSET_OP_Root(id, method, arity)
#define ZEROSET_OP_Wave(id, method, arity)
#define ZEROSET_OP_Lookup(id, method, arity)
#define ZEROSET_OP_Call(id, method, arity) ZEROSET_APPLY_##arity(id, method)
#define ZEROSET_OP_Compare(id, method, arity) ZEROSET_APPLY_##arity(id, method)
#define ZEROSET_OP_Logic(id, method, arity) ZEROSET_APPLY_##arity(id, method)
#define ZEROSET_OP_Internal(id, method, arity) ZEROSET_APPLY_##arity(id, method)
#define ZEROSET_OP(id, method, spelling, arity, notation, about) \
    ZEROSET_OP_##notation(id, method, arity)
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
#undef ZEROSET_APPLY_1
#undef ZEROSET_APPLY_2
#undef ZEROSET_APPLY_3
    }
    return a.value;
}

/// Whether the node is taken from outside the graph, not computed from operands.
inline bool is_leaf(const Node& node, const Facts& facts) {
    return facts.constant || arity(node.op) == 0;
}

/// The operator of a node that is no leaf on its operands, which `operand(id)` gives.
template <class Algebra>
typename Algebra::Value apply_to(Algebra& algebra, const Node& node, auto operand) {
    const int operands = arity(node.op);
    return apply(algebra, node, operand(node.a), operand(operands < 2 ? node.a : node.b),
                 operand(operands < 3 ? node.a : node.c));
}

/// Tells an algebra that knows switches which one comes next.
template <class Algebra>
void enter_switch(Algebra& algebra, SwitchIndex index) {
    if constexpr (requires { algebra.enter(index); }) algebra.enter(index);
}

/// The root's value. `leaf(node, facts)` makes the value of a variable or a constant subexpression.
/// Nodes that are the same for a whole batch are computed first; `varying()` is called between.
/// `computed()` is called after each of the others.
template <class Algebra, class Leaf, class Varying, class Computed = decltype([] {})>
typename Algebra::Value evaluate(const Expr& expr, std::span<const Facts> facts, Algebra& algebra,
                                 Leaf leaf, Varying varying, Computed computed = {}) {
    const std::vector<SwitchIndex> switches = switches_of(expr, facts);
    std::vector<std::optional<typename Algebra::Value>> values(expr.nodes().size());
    const auto operand = [&](NodeId id) {
        return Operand<typename Algebra::Value>{*values[id], facts[id]};
    };
    const auto compute = [&](NodeId id) -> typename Algebra::Value {
        const Node& node = expr.node(id);
        if (is_leaf(node, facts[id])) return leaf(node, facts[id]);
        enter_switch(algebra, switches[id]);
        return apply_to(algebra, node, operand);
    };
    for (NodeId id = 0; id <= expr.root(); ++id) {
        if (facts[id].uniform) values[id] = compute(id);
    }
    varying();
    for (NodeId id = 0; id <= expr.root(); ++id) {
        if (facts[id].uniform) continue;
        values[id] = compute(id);
        computed();
    }
    return *values.back();
}

}  // namespace zeroset
