#include "engine/expr/copy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace zeroset::copy_test {
namespace {

/// A graph of each kind of leaf and of operators with one to three operands, one of them used
/// twice: if(x < a, (x + 0.1)^3, -(x + 0.1)).
Expr sample() {
    ExprBuilder builder;
    const NodeId x = builder.variable(0);
    const NodeId sum = builder.apply(Op::Add, x, builder.constant(0.09, 0.11));
    const NodeId less = builder.apply(Op::Less, x, builder.variable(variable_w + 1));
    const NodeId cube = builder.apply(Op::IntPower, sum, 0, 0, 3);
    const NodeId root = builder.apply(Op::If, less, cube, builder.apply(Op::Negate, sum));
    return builder.finish(root, {"a"});
}

TEST(CopyNodes, AreTheSameGraph) {
    const Expr expr = sample();
    ExprBuilder builder;
    const std::vector<NodeId> copies = copy_nodes(builder, expr);
    ASSERT_EQ(copies.size(), expr.nodes().size());
    EXPECT_EQ(builder.size(), expr.nodes().size());
    EXPECT_EQ(builder.finish(copies.back(), {"a"}).key(), expr.key());
}

TEST(CopyNodes, MakesOperatorsOnly) {
    const Expr expr = sample();
    std::vector<Op> made;
    const Expr copy =
        rebuilt(expr, [&](ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
            made.push_back(node.op);
            return copy_node(builder, node, a, b, c);
        });
    EXPECT_EQ(copy.key(), expr.key());
    EXPECT_EQ(made.size(), 5U);
}

TEST(CopyNode, AsksForTheOperandsItHas) {
    const Expr expr = sample();
    for (const Node& node : expr.nodes()) {
        ExprBuilder builder;
        builder.variable(0);
        std::vector<NodeId> asked;
        copy_node(builder, node, [&](NodeId id) {
            asked.push_back(id);
            return NodeId{0};
        });
        EXPECT_EQ(asked.size(), static_cast<std::size_t>(arity(node.op)));
    }
}

TEST(CopyNode, TakesOtherOperands) {
    ExprBuilder builder;
    const std::array operands{builder.variable(0), builder.variable(1), builder.variable(2)};
    const Node sum{.op = Op::Add, .a = 2, .b = 1};
    const NodeId copy = copy_node(builder, sum, operands);
    EXPECT_EQ(builder.node(copy), sum);
    const NodeId turned = copy_node(builder, sum, operands[1], operands[2], 0);
    EXPECT_EQ(builder.node(turned).a, operands[1]);
    EXPECT_EQ(builder.node(turned).b, operands[2]);
}

TEST(Rebuilt, PutsOtherOperatorsInPlace) {
    const Expr expr = sample();
    const Expr other =
        rebuilt(expr, [](ExprBuilder& builder, const Node& node, NodeId a, NodeId b, NodeId c) {
            return node.op == Op::If ? b : copy_node(builder, node, a, b, c);
        });
    EXPECT_EQ(other.nodes().size(), 4U);
    EXPECT_EQ(other.node(other.root()).op, Op::IntPower);
    EXPECT_EQ(other.parameters().size(), 1U);
}

}  // namespace
}  // namespace zeroset::copy_test
