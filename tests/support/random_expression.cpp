#include "tests/support/random_expression.hpp"

#include "engine/expr/number.hpp"
#include "engine/expr/simplify.hpp"

#include <array>

namespace zeroset::test {
namespace {

NodeId random_leaf(ExprBuilder& builder, RandomNumbers& random) {
    static constexpr std::array texts{"0",   "1",    "2",     "3",    "0.1",      "0.7", "1.5",
                                      "2.4", "0.05", "1e-30", "1e30", "16777217", "0.25"};
    if (!random.one_in(4)) return builder.variable(random.between(0, variable_w));
    const NumberEnclosure number = enclose_number(texts[random.below(texts.size())]);
    const NodeId constant = builder.constant(number.lo, number.hi);
    return random.one_in(3) ? make_negate(builder, constant) : constant;
}

NodeId made(ExprBuilder& builder, const OpInfo& info, NodeId a, NodeId b, int n) {
    switch (info.notation) {
        case Notation::Prefix: return make_negate(builder, a);
        case Notation::Infix: break;
        case Notation::Power: return make_power(builder, a, builder.constant(n));
        case Notation::Call: return make_call(builder, info.op, a, b);
        case Notation::Internal:
            return make_call(
                builder, Op::Sin,
                make_multiply(builder, builder.constant(n), make_call(builder, Op::Atan2, a, b)),
                0);
    }
    if (info.op == Op::Add) return make_add(builder, a, b);
    if (info.op == Op::Subtract) return make_subtract(builder, a, b);
    if (info.op == Op::Multiply) return make_multiply(builder, a, b);
    return make_divide(builder, a, b);
}

NodeId random_node(ExprBuilder& builder, RandomNumbers& random, int depth) {
    if (depth == 0 || random.one_in(8)) return random_leaf(builder, random);
    const OpInfo& info = operators()[random.below(operators().size())];
    const NodeId a = random_node(builder, random, depth - 1);
    const bool binary = info.arity == 2;
    const bool shared = binary && random.one_in(6);
    const NodeId b = binary && !shared ? random_node(builder, random, depth - 1) : a;
    return made(builder, info, a, b, random.between(-3, 9));
}

}  // namespace

Expr random_expression(RandomNumbers& random, int depth) {
    ExprBuilder builder;
    return builder.finish(random_node(builder, random, depth));
}

Expr operator_on_variables(const OpInfo& info, int n) {
    ExprBuilder builder;
    const NodeId x = builder.variable(0);
    const NodeId y = builder.variable(1);
    return builder.finish(builder.apply(info.op, x, y, info.notation == Notation::Power ? n : 0));
}

}  // namespace zeroset::test
