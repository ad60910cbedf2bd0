#include "engine/expr/copy.hpp"
#include "engine/rewrite/surface_functions.hpp"

#include <array>

namespace zeroset {
namespace {

bool is_variable(const Expr& f, NodeId id, int variable) {
    const Node& node = f.node(id);
    return node.op == Op::Variable && node.number == variable;
}

/// Whether the node is a field itself, at the point.
bool is_plain_field(const Expr& f, NodeId id) {
    const Node& node = f.node(id);
    return node.op == Op::Field && node.number == 0 && is_variable(f, node.a, 0) &&
           is_variable(f, node.b, 1) && is_variable(f, node.c, 2);
}

/// The graph below a node, negated where that is asked for.
Expr below(const Expr& f, NodeId id, bool negated) {
    ExprBuilder nodes;
    copy_nodes(nodes, f);
    const auto names = f.parameters();
    const NodeId root = negated ? nodes.apply(Op::Negate, id) : id;
    return nodes.finish(root, {names.begin(), names.end()});
}

/// The field of the node `field` compared with the node `level`.
std::optional<LevelOfField> compared(const Expr& f, NodeId field, NodeId level, bool negated) {
    if (!is_plain_field(f, field)) return std::nullopt;
    LevelOfField result{.field = f.node(field).field, .level = below(f, level, negated)};
    for (int variable = 0; variable < variable_w; ++variable) {
        if (result.level.uses_variable(variable)) return std::nullopt;
    }
    return result;
}

}  // namespace

std::optional<LevelOfField> level_of_field(const Expr& f) {
    NodeId root = f.root();
    while (f.node(root).op == Op::Negate)
        root = f.node(root).a;
    const Node& node = f.node(root);
    if (is_plain_field(f, root)) {
        ExprBuilder zero;
        const auto names = f.parameters();
        return LevelOfField{.field = node.field,
                            .level = zero.finish(zero.constant(0.0), {names.begin(), names.end()})};
    }
    if (node.op != Op::Add && node.op != Op::Subtract) return std::nullopt;
    const bool is_sum = node.op == Op::Add;
    if (auto first = compared(f, node.a, node.b, is_sum)) return first;
    return compared(f, node.b, node.a, is_sum);
}

}  // namespace zeroset
