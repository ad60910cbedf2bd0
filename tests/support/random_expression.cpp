#include "tests/support/random_expression.hpp"

#include "engine/expr/number.hpp"
#include "engine/expr/simplify.hpp"
#include "tests/support/op_names.hpp"
#include "tests/support/sample_field.hpp"

#include <array>
#include <cstdlib>

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

NodeId random_condition(ExprBuilder& builder, RandomNumbers& random, int depth);
NodeId random_node(ExprBuilder& builder, RandomNumbers& random, int depth);

/// Up to three operands of the kinds that the operator takes, now and then one of them twice.
std::array<NodeId, 3> random_operands(ExprBuilder& builder, RandomNumbers& random,
                                      const OpInfo& info, int depth) {
    std::array<NodeId, 3> operands{};
    for (int k = 0; k < info.arity; ++k) {
        NodeId& operand = operands.at(static_cast<std::size_t>(k));
        const bool condition = takes_condition(info, k);
        const bool shared = k > 0 && condition == takes_condition(info, k - 1) && random.one_in(6);
        if (shared) {
            operand = operands.at(static_cast<std::size_t>(k - 1));
        } else {
            operand = condition ? random_condition(builder, random, depth)
                                : random_node(builder, random, depth);
        }
    }
    return operands;
}

NodeId made_infix(ExprBuilder& builder, Op op, NodeId a, NodeId b) {
    if (op == Op::Add) return make_add(builder, a, b);
    if (op == Op::Subtract) return make_subtract(builder, a, b);
    if (op == Op::Multiply) return make_multiply(builder, a, b);
    return make_divide(builder, a, b);
}

NodeId made(ExprBuilder& builder, const OpInfo& info, const std::array<NodeId, 3>& operands,
            int n) {
    const auto [a, b, c] = operands;
    switch (info.notation) {
        case Notation::Prefix: return make_negate(builder, a);
        case Notation::Infix: return made_infix(builder, info.op, a, b);
        case Notation::Power: return make_power(builder, a, builder.constant(n));
        case Notation::Root: return make_root(builder, a, 2 * (std::abs(n) % 5) + 3);
        case Notation::Wave: return builder.apply(info.op, a, b, 0, std::abs(n) + 1);
        case Notation::Lookup: return applied(builder, info.op, a, b, c);
        case Notation::Call:
        case Notation::Compare:
        case Notation::Logic: break;
        case Notation::Internal:
            if (info.op != Op::Angle) return builder.apply(info.op, a, b);
            return make_call(
                builder, Op::Sin,
                make_multiply(builder, builder.constant(n), make_call(builder, Op::Atan2, a, b)),
                0);
    }
    return make_call(builder, info.op, a, b, c);
}

/// A random operator whose value is a condition, or for false one whose value is a number.
const OpInfo& random_operator(RandomNumbers& random, bool condition) {
    for (;;) {
        const OpInfo& info = operators()[random.below(operators().size())];
        if (is_condition(info) == condition) return info;
    }
}

NodeId random_condition(ExprBuilder& builder, RandomNumbers& random, int depth) {
    const OpInfo& info = depth == 0 ? op_info(Op::Less) : random_operator(random, true);
    const int below = depth == 0 ? 0 : depth - 1;
    return made(builder, info, random_operands(builder, random, info, below), 0);
}

NodeId random_node(ExprBuilder& builder, RandomNumbers& random, int depth) {
    if (depth == 0 || random.one_in(8)) return random_leaf(builder, random);
    const OpInfo& info = random_operator(random, false);
    const auto operands = random_operands(builder, random, info, depth - 1);
    return made(builder, info, operands, random.between(-3, 9));
}

}  // namespace

Expr random_expression(RandomNumbers& random, int depth) {
    ExprBuilder builder;
    return builder.finish(random_node(builder, random, depth));
}

Expr operator_on_variables(const OpInfo& info, int n) {
    ExprBuilder builder;
    const std::array variables{builder.variable(0), builder.variable(1), builder.variable(2)};
    const std::array conditions{builder.apply(Op::Less, variables[0], variables[1]),
                                builder.apply(Op::LessEqual, variables[2], variables[0])};
    const auto operand = [&](int k) {
        const auto index = static_cast<std::size_t>(k);
        return takes_condition(info, k) ? conditions.at(index) : variables.at(index);
    };
    const bool numbered = info.notation == Notation::Power || info.notation == Notation::Root ||
                          info.notation == Notation::Wave;
    return builder.finish(applied(builder, info.op, operand(0), info.arity < 2 ? 0 : operand(1),
                                  info.arity < 3 ? 0 : operand(2), numbered ? n : 0));
}

}  // namespace zeroset::test
