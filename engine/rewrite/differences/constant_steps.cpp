#include "engine/expr/exact.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/rewrite/differences/differences.hpp"

namespace zeroset {
namespace {

constexpr int max_offsets = 8;  ///< constants that are added to one base

/// base + offset, a constant, or offset - base.
struct Shifted {
    NodeId base;
    NodeId offset;
    bool negated = false;

    /// Takes the next summand or sign off the base; false where there is none.
    bool peel(ExprBuilder& builder);

private:
    void add(ExprBuilder& builder, NodeId constant, bool negative) {
        offset = negative != negated ? make_subtract(builder, offset, constant)
                                     : make_add(builder, offset, constant);
    }
};

bool Shifted::peel(ExprBuilder& builder) {
    const Node node = builder.node(base);
    const bool difference = node.op == Op::Subtract;
    if (node.op == Op::Negate) {
        negated = !negated;
        base = node.a;
        return true;
    }
    if (node.op != Op::Add && !difference) return false;
    if (exact_fraction(builder, node.b)) {
        add(builder, node.b, difference);
        base = node.a;
        return true;
    }
    if (!exact_fraction(builder, node.a)) return false;
    add(builder, node.a, false);
    negated = negated != difference;
    base = node.b;
    return true;
}

Shifted shifted(ExprBuilder& builder, NodeId id) {
    Shifted result{.base = id, .offset = builder.constant(0.0)};
    for (int i = 0; i < max_offsets && result.peel(builder); ++i) {
    }
    return result;
}

}  // namespace

std::optional<Fraction> step_between(ExprBuilder& builder, NodeId f1, NodeId f0) {
    const Shifted to = shifted(builder, f1);
    const Shifted from = shifted(builder, f0);
    if (to.base != from.base || to.negated != from.negated) return std::nullopt;
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
