#include "engine/expr/constant_steps.hpp"

namespace zeroset {
namespace {

constexpr int max_offsets = 8;  ///< constants that are added to one base

/// base + offset, a constant.
struct Shifted {
    NodeId base;
    NodeId offset;
};

Shifted shifted(ExprBuilder& builder, NodeId id) {
    Shifted result{id, builder.constant(0.0)};
    for (int i = 0; i < max_offsets; ++i) {
        const Node node = builder.node(result.base);
        if (node.op != Op::Add && node.op != Op::Subtract) break;
        if (exact_fraction(builder, node.b)) {
            result.offset = node.op == Op::Add ? make_add(builder, result.offset, node.b)
                                               : make_subtract(builder, result.offset, node.b);
            result.base = node.a;
        } else if (node.op == Op::Add && exact_fraction(builder, node.a)) {
            result.offset = make_add(builder, result.offset, node.a);
            result.base = node.b;
        } else {
            break;
        }
    }
    return result;
}

}  // namespace

std::optional<Fraction> step_between(ExprBuilder& builder, NodeId f1, NodeId f0) {
    const Shifted to = shifted(builder, f1);
    const Shifted from = shifted(builder, f0);
    if (to.base != from.base) return std::nullopt;
    return exact_fraction(builder, make_subtract(builder, to.offset, from.offset));
}

NodeId constant_of(ExprBuilder& builder, const Fraction& value) {
    return make_divide(builder, builder.constant(static_cast<double>(value.p)),
                       builder.constant(static_cast<double>(value.q)));
}

NodeId ratio(ExprBuilder& builder, NodeId a, NodeId b) {
    if (a == b) return builder.constant(1.0);
    const NodeId quotient = make_divide(builder, a, b);
    const auto exact = exact_fraction(builder, quotient);
    return exact ? constant_of(builder, *exact) : quotient;
}

}  // namespace zeroset
